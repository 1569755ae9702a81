#pragma once

#include <array>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "tests/library/geometry.h"

/// Independent solutions of the library's mechanisms, each by its own geometry: closed forms, or a
/// few equations in joint angles or in the pose of one body. They share nothing with desmo:
/// dimensions and motions are typed again; coordinates, constraints and derivatives are their own.
/// Units are metres (or the mechanism's free unit), radians, seconds; numbers are long double.
namespace desmo::exact {

/// A point, a vector (2 or 3 components) or a relative coordinate (1).
struct Quantity {
  int size;
  std::array<double, 3> position, velocity, acceleration;
};

/// The quantities named in a mechanism's file, at one instant. Angles are modulo 2π.
struct Solution {
  std::map<std::string, Quantity, std::less<>> quantities;

  void add(std::string name, Jet scalar);
  template <std::size_t D>
  void add(std::string name, const Vec<D>& x) {
    Quantity q{static_cast<int>(D), {}, {}, {}};
    for (std::size_t i = 0; i < D; ++i) set(q, i, x[i]);
    quantities.emplace(std::move(name), q);
  }

 private:
  static void set(Quantity& q, std::size_t i, Jet x);
};

/// The solution of a library mechanism as a function of time [s].
struct LibrarySolution {
  std::string_view mechanism;
  Solution (*at)(double t);
};

/// Returns the solutions of all mechanisms of the library.
std::span<const LibrarySolution> library_solutions();

// Solutions at time t [s], with the motion of the mechanism's scene.
Solution slider_crank(double t);
Solution inverted_slider_crank(double t);
Solution whitworth(double t);
Solution watt_six_bar(double t);
Solution stephenson_six_bar(double t);
Solution jansen_leg(double t);
Solution andrews(double t);
Solution rssr(double t);
Solution stewart(double t);
Solution delta(double t);
Solution double_wishbone(double t);
Solution macpherson(double t);
Solution truck_axle(double t);

}  // namespace desmo::exact
