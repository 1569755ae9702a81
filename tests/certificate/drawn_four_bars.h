// Four-bars with a change point, drawn at random, and their closed forms.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <span>

#include "cases/extremes/rows.h"
#include "formulations/modelling/modelling.h"
#include "formulations/verification/branch/branch_path.h"
#include "formulations/verification/branch/passage.h"
#include "tests/certificate/starts.h"

namespace desmo {

/// A four-bar whose bars are in line where the crank is at `point`, but for the rounding of its
/// lengths.
struct FourBar {
  double crank, base, coupler, rocker, point;

  double to_pivot(double theta) const {
    return std::hypot(base - crank * std::cos(theta), crank * std::sin(theta));
  }
  /// Returns whether the bars close with a margin, which grows with the distance from the point.
  bool closes_at(double theta) const {
    const double distance = to_pivot(theta), margin = 0.05 * (theta - point) * (theta - point);
    return distance < coupler + rocker - margin && distance > std::abs(coupler - rocker) + margin;
  }
  /// Returns the four-bar with its crank at an angle. side: 1 or −1: the joint of coupler and
  /// rocker is left or right of the line from the crank's pin to the rocker's pivot.
  DyadChain drawn_at(double theta, int side) const {
    return extremes::one_dyad(crank, theta, base, coupler, rocker, side);
  }
  /// Returns the joint of coupler and rocker.
  Mechanism::Vec joint(double theta, int side) const {
    return drawn_at(theta, side).dyads.front().joint;
  }
};

/// Draws a four-bar of one of four kinds that moves for a radian on both sides of the point.
inline FourBar drawn_four_bar(std::mt19937& generator) {
  std::uniform_int_distribution<int> parts(12, 64);
  const double unit = generator() % 2 ? 10 : 16;  // sixteenths are not rounded, tenths are
  const auto length = [&] { return parts(generator) / unit; };
  for (int kind = static_cast<int>(generator() % 4);;) {
    FourBar f{length(), length(), length(), 0, 0};
    if (kind == 0) {  // stretched
      f.point = std::numbers::pi;
      f.rocker = f.crank + f.base - f.coupler;
    } else if (kind == 1) {  // folded
      f.rocker = f.coupler + (generator() % 2 ? f.base - f.crank : f.crank - f.base);
    } else if (kind == 2) {  // parallelogram
      f.coupler = f.base, f.rocker = f.crank;
      f.point = generator() % 2 ? std::numbers::pi : 0;
    } else {  // kite
      f.base = f.crank, f.rocker = f.coupler;
    }
    bool moves = f.rocker > 0.25 && (kind == 3 || f.base != f.crank);
    for (int i = 1; i <= 20; ++i)
      for (const int sign : {-1, 1}) moves &= f.closes_at(f.point + sign * i / 20.0);
    if (moves) return f;
  }
}

/// Returns how far the joint of coupler and rocker is from a point.
inline double joint_distance(const Model& m, std::span<const double> q,
                             const Mechanism::Vec& point) {
  const int c = m.entities[m.find("dyad1/C")].first;
  return std::hypot(q[c] - point[0], q[c + 1] - point[1]);
}

/// A four-bar before a change point.
struct DrawnFourBar {
  FourBar bars;
  int side;
  double sign;  ///< of the crank's way to the point

  explicit DrawnFourBar(std::mt19937& generator) : bars(drawn_four_bar(generator)) {
    side = generator() % 2 ? 1 : -1;
    sign = generator() % 2 ? 1 : -1;
  }
  Model model(const Motion& motion) const {
    const DyadChain chain = bars.drawn_at(bars.point - 0.7 * sign, side);
    return make_model(extremes::case_of("drawn", {chain}, {motion}, {-1, 0.01, 201}).scene);
  }
  /// Returns the joint on the point, from the middles of positions about it.
  Mechanism::Vec joint_on_point() const {
    const auto middle = [&](double distance, int i) {
      const double near = sign * distance;
      return (bars.joint(bars.point - near, side)[i] + bars.joint(bars.point + near, -side)[i]) / 2;
    };
    const double h = 1e-4;
    return {(4 * middle(h, 0) - middle(2 * h, 0)) / 3, (4 * middle(h, 1) - middle(2 * h, 1)) / 3,
            0};
  }
  /// Goes on from a passed point, and compares with the closed form.
  void expect_continued(const Model& m, PassedPoint& point, bool passes) const {
    EXPECT_LE(joint_distance(m, positions_on(point, m, 0), joint_on_point()), 1e-7);
    BranchPath path(m);
    ASSERT_TRUE(path.start_at(point.beyond()));
    for (const double t : {0.25, 0.5, 1.0}) {
      EXPECT_EQ(path.go_to(t).end, PathEnd::same);
      const double theta = sample(m.drivers[0].motion, t).position;
      const Mechanism::Vec joint = bars.joint(theta, passes ? -side : side);
      EXPECT_LE(joint_distance(m, path.present().values.position, joint), 1e-10) << t;
    }
  }
};

}  // namespace desmo
