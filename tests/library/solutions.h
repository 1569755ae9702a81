#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "formulations/base/per_level.h"
#include "tests/library/geometry.h"

/// Independent solutions of the library's mechanisms, each by its own geometry: closed forms, or a
/// few equations in joint angles or in the pose of one body. They share nothing with desmo:
/// dimensions and motions are typed again; coordinates, constraints and derivatives are their own.
/// Units are metres (or the mechanism's free unit), radians, seconds; numbers are long double.
namespace desmo::exact {

/// A point, a vector (2 or 3 components) or a relative coordinate (1).
struct Quantity {
  int size;
  PerLevel<std::array<double, 3>> levels{};

  Quantity(Jet scalar) : Quantity(std::array{scalar}) {}
  template <std::size_t D>
  Quantity(const std::array<Jet, D>& x) : size(D) {
    for (const Level level : all_levels)
      for (std::size_t i = 0; i < D; ++i) levels[level][i] = static_cast<double>(x[i].at(level));
  }
};

/// The quantities named in a mechanism's file, at one instant. Angles are modulo 2π.
using Solution = std::map<std::string, Quantity, std::less<>>;

/// A solution at time t [s], with the motion of the mechanism's scene.
using SolutionAt = Solution(double t);
SolutionAt slider_crank, inverted_slider_crank, whitworth, watt_six_bar, stephenson_six_bar,
    jansen_leg, andrews, rssr, stewart, delta, double_wishbone, macpherson, truck_axle;

/// Returns the solutions of all mechanisms of the library.
const std::map<std::string_view, SolutionAt*>& library_solutions();

}  // namespace desmo::exact
