// Starts of paths, and what tells whether the drawing leads to constant drivers.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "formulations/model/model.h"
#include "formulations/motion/groupwise/double_solution.h"
#include "formulations/verification/branch/branch_path.h"
#include "formulations/verification/branch/passage.h"
#include "formulations/verification/branch/straight_path.h"
#include "tests/certificate/containment.h"
#include "tests/properties/continuation.h"

namespace desmo {

inline constexpr double whole_turn = 2 * std::numbers::pi;

/// Refines a solved instant, and expects a proof. The result is valid until the next refinement.
inline CertifiedInstant refined(Refinement& refinement, const ReferenceInstant& s) {
  const RefinedInstant& r = refinement.refine(instant_of(s));
  EXPECT_TRUE(r.proven) << s.time;
  return certified(r);
}

/// Starts at the model's estimate at a time.
inline bool start(const Model& m, double time, BranchPath& path) {
  const ReferenceInstant s = double_solution(m, std::span(&time, 1)).front();
  return path.start_at({time, {s.q, {}, {}}, {}});
}

/// A path that begins at the model's estimate at a time, and is stuck on the way to another one.
struct StuckPath : BranchPath {
  StuckPath(const Model& m, double from, double to) : BranchPath(m) {
    EXPECT_TRUE(start(m, from, *this)) << m.name;
    EXPECT_EQ(go_to(to).end, PathEnd::stuck) << m.name;
  }
};

/// Passes a change point, whose group is not known, by a budget of its own. beginning: direction of
/// the drivers and time [s], where the motion begins on the point.
std::optional<PassedPoint> passage_of(const Model& m, const CertifiedInstant& last,
                                      const auto&... beginning) {
  TestBudget budget(BranchPath::max_tests);
  return pass_change_point(m, last, beginning..., no_position, budget);
}

/// Returns the positions on a passed point of a model at a time.
inline std::vector<double> positions_on(PassedPoint& point, const Model& m, double time) {
  StraightPath path(m);
  return point.find_positions(path, time);
}

/// Returns the largest distance of two positions, without whole turns of angles.
inline double position_distance(const Model& m, const std::vector<double>& a,
                                const std::vector<double>& b) {
  double largest = 0;
  for (const Entity& e : m.entities) {
    if (e.fixed) continue;
    for (int i = e.first; i < e.first + e.size; ++i) {
      double off = a[i] - b[i];
      if (e.kind == EntityKind::angle) off = std::remainder(off, whole_turn);
      largest = std::max(largest, std::abs(off));
    }
  }
  return largest;
}

/// Returns the values of the drivers as they are drawn.
inline std::vector<double> drawn_drivers(const Model& m) {
  std::vector<double> values;
  for (const Driver& d : m.drivers) values.push_back(m.estimate[m.entities[d.coordinate].first]);
  return values;
}

/// Returns the model with constant drivers.
inline Model held_at(Model m, const std::vector<double>& values) {
  for (std::size_t k = 0; k < values.size(); ++k) m.drivers[k].motion = Polynomial{{values[k]}};
  return m;
}

/// Returns the model with drivers that go from the drawing straight to these values, in a time [s].
inline Model led_to(Model m, const std::vector<double>& values, double time) {
  const std::vector<double> from = drawn_drivers(m);
  for (std::size_t k = 0; k < values.size(); ++k)
    m.drivers[k].motion = Polynomial{{from[k], (values[k] - from[k]) / time}};
  return m;
}

/// Follows drivers from the drawing straight to these values, in steps of `step` in each driver, by
/// Newton's method alone. Returns the positions there; empty: it did not converge.
inline std::vector<double> in_short_steps(const Model& m, const std::vector<double>& to,
                                          double step) {
  const std::vector<double> from = drawn_drivers(m);
  double longest = 0;
  for (std::size_t k = 0; k < to.size(); ++k)
    longest = std::max(longest, std::abs(to[k] - from[k]));
  const double seconds = std::max(0.01, longest / step * 0.01);  // in steps of 10 ms
  try {
    return double_solution(led_to(m, to, seconds), std::vector{0.0, seconds}).back().q;
  } catch (const std::runtime_error&) {
    return {};
  }
}

/// Returns whether the judge finds a regular way from the drawing to these values of the drivers.
/// Nearer to a singular position than this condition number says nothing has to be proven.
inline bool has_way(const Model& m, const std::vector<double>& to) {
  constexpr double max_condition = 1e7;
  const Model led = led_to(m, to, 1);
  Continuation way(led);
  way.begin(motions_of(led), 0);
  return way.go_to(1) && way.crossings() == 0 && way.max_condition() < max_condition;
}

}  // namespace desmo
