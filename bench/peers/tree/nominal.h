#pragma once

#include <string>

#include "bench/peers/named.h"
#include "bench/peers/tree/moving.h"
#include "cases/mechanism/mechanism.h"

namespace desmo::tree {

// Dimensions are read off the nominal position. All throw std::invalid_argument when there is no
// such name.

inline Vec nominal(const Mechanism& d, const std::string& point) {
  return Vec(named(d.points, point).position.data());
}

/// Returns the length of a link whose nominal position is but an estimate.
inline double length(const Mechanism& d, const std::string& link) {
  return named(d.bodies, link).length.value();
}

}  // namespace desmo::tree
