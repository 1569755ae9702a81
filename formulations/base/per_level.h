#pragma once

#include <array>

#include "cases/mechanism/level.h"

namespace desmo {

/// The three levels, ascending.
inline constexpr std::array all_levels{Level::position, Level::velocity, Level::acceleration};
/// The levels that are rates.
inline constexpr std::array rate_levels{Level::velocity, Level::acceleration};

/// A value for each level.
template <class T>
struct PerLevel {
  T position{}, velocity{}, acceleration{};

  T& operator[](Level level) { return at(*this, level); }
  const T& operator[](Level level) const { return at(*this, level); }
  bool operator==(const PerLevel&) const = default;

 private:
  static auto& at(auto& values, Level level) {
    return level == Level::position   ? values.position
           : level == Level::velocity ? values.velocity
                                      : values.acceleration;
  }
};

/// Names of the levels, in files and for people.
inline constexpr PerLevel<const char*> level_names{"position", "velocity", "acceleration"};

}  // namespace desmo
