// The start of a motion: the branch of the drawing, or what keeps the drivers from leading to it.

#include "formulations/verification/branch/start.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "cases/extremes/rows.h"
#include "formulations/model/scales.h"
#include "tests/certificate/starts.h"
#include "tests/dead_point.h"
#include "tests/mechanisms.h"

namespace desmo::start_test {
namespace {

using Stage = FoundStart::Stage;

/// All mechanisms from two turns before to two turns after the drawing, each time at another
/// instant. The arms of the delta are in line with its platform on the way of a turn.
TEST(Start, IsOnTheBranchOfTheDrawing) {
  int reached = 0, blocked = 0;
  for (const auto& [m, grid] : every_motion()) {
    // Sanitized code is as slow where a way is long.
    const double share = DESMO_SANITIZED ? 0.02 : 0.37,
                 later = grid.start + share * (grid.time(grid.instants - 1) - grid.start);
    std::vector<std::pair<double, double>> starts{{DESMO_SANITIZED ? 0.02 : 0.3, later}};
    if (!DESMO_SANITIZED)
      starts.insert(starts.end(), {{0, later},
                                   {0, grid.start},
                                   {-0.45, grid.start},
                                   {0.8, later},
                                   {-1.6, grid.start},
                                   {2, later}});
    for (const auto& [turns, time] : starts) {
      // Others take the delta through as many singular positions again.
      if (m.name == "delta" && (turns < 0 || turns > 1)) continue;
      std::vector<double> to;
      for (const Driver& d : m.drivers) {
        to.push_back(sample(d.motion, time).position);
        if (m.entities[d.coordinate].kind == EntityKind::angle) to.back() += turns * whole_turn;
      }
      SCOPED_TRACE(m.name + ", " + std::to_string(turns) + " turns, " + std::to_string(time));
      const Model held = held_at(m, to);
      const FoundStart found = find_start(held, 0);
      if (found.stage != Stage::reached) {
        ++blocked;
        EXPECT_EQ(found.stage, Stage::drivers);
        EXPECT_FALSE(has_way(m, to)) << found.share;
        continue;
      }
      ++reached;
      EXPECT_EQ(found.share, 1);
      const std::vector<double> right = in_short_steps(m, to, 0.03);
      ASSERT_FALSE(right.empty());
      EXPECT_LT(position_distance(m, found.q, right), 1e-9 * nominal_size(m));
      for (const Entity& e : m.entities)
        if (!e.fixed && e.kind == EntityKind::angle && !independent_coordinates(m)[e.first])
          EXPECT_LE(std::abs(found.q[e.first] - m.estimate[e.first]), whole_turn / 2 + 1e-9);
    }
  }
  std::cout << reached << " reached, " << blocked << " blocked\n";
  EXPECT_GE(reached, 10 * blocked);
}

Model four_bar(double coupler, double rocker, double base, double drawn) {
  const DyadChain chain = extremes::one_dyad(1, drawn, base, coupler, rocker);
  return make_model(extremes::case_of("four_bar", chain, 0, {0, 1, 2}).scene);
}

/// Bars of 1, 3 and 4 on a base of 5.99 are nearly stretched at half a turn: from there Newton's
/// method leads to the other branch.
TEST(Start, GoesShortStepsFromANearlyStretchedDrawing) {
  const Model m = four_bar(3, 4, 5.99, whole_turn / 2);
  for (const double turns : {0, 1, -2})
    EXPECT_NEAR(m.value("dyad1/C.y", find_start(held_at(m, {2.5 + turns * whole_turn}), 0).q),
                1.127, 1e-3);
}

/// A parallelogram is at a change point each half turn.
TEST(Start, PassesChangePoints) {
  const Model m = four_bar(4, 1, 4, whole_turn / 4);
  for (const double to : {0.3, 0.6, -0.1, 1.7, -1.2}) {
    const FoundStart found = find_start(held_at(m, {to * whole_turn}), 0);
    EXPECT_EQ(found.stage, Stage::reached) << to;
    EXPECT_NEAR(std::remainder(m.value("dyad1/psi", found.q) - to * whole_turn, whole_turn), 0,
                1e-12)
        << to;
    std::vector<double> points;  // each half turn on the way
    for (double at = to > 0 ? 0.5 : 0; std::abs(at - 0.25) < std::abs(to - 0.25);
         at += to > 0 ? 0.5 : -0.5)
      points.push_back((at - 0.25) / (to - 0.25));
    ASSERT_EQ(found.passed.size(), points.size()) << to;
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_NEAR(found.passed[i], points[i], 1e-6);
  }
}

/// One that begins on a change point has no proven start.
TEST(Start, SaysThatItIsOnAChangePoint) {
  const FoundStart found =
      find_start(held_at(four_bar(4, 1, 4, whole_turn / 4), {whole_turn / 2}), 0);
  EXPECT_EQ(found.stage, Stage::drivers);
  EXPECT_NEAR(found.share, 1, 1e-6);
  EXPECT_NEAR(found.q[0], -1, 1e-3);
  ASSERT_NE(found.group, no_position);
}

TEST(Start, SaysWhereTheDriversAreBlocked) {
  const double drawn = std::numbers::pi / 3, to = dead_point + 0.2;
  const Model m = locking_four_bar();
  const FoundStart found = find_start(held_at(m, {to}), 0);
  EXPECT_EQ(found.stage, Stage::drivers);
  EXPECT_NEAR(drawn + found.share * (to - drawn), dead_point, 1e-9);
  EXPECT_NEAR(m.value("crank/theta", found.q), dead_point, 1e-9);
  ASSERT_NE(found.group, no_position);
  EXPECT_EQ(m.groups[found.group].name, "dyad1/SG-I");
}

TEST(Start, SaysThatADrawingIsSingular) {
  const Model m = locking_four_bar(Polynomial{{dead_point}});
  const FoundStart found = find_start(held_at(m, {1.0}), 0);
  EXPECT_EQ(found.stage, Stage::drawing);
  EXPECT_EQ(found.share, 0);
  EXPECT_EQ(found.q, m.estimate);
  ASSERT_NE(found.group, no_position);
  EXPECT_EQ(m.groups[found.group].name, "dyad1/SG-I");
}

/// A coupler too short to close the loop: the way ends where crank pin, coupler and rocker are in
/// line. There (1 − λ) Φ(drawing) is what the closure lacks.
TEST(Start, SaysHowFarADrawingThatCannotCloseLeads) {
  Model m = locking_four_bar();
  for (Constraint& c : m.constraints)
    if (c.name.starts_with("dyad1/coupler")) c.constants[0] = 1;
  const FoundStart found = find_start(m, 0);
  EXPECT_EQ(found.stage, Stage::drawing);
  // With the length l of coupler and rocker in line: l² = 1 + (1 − λ) (9 − 1).
  const double line = std::hypot(8 - 2 * std::cos(std::numbers::pi / 3), std::sqrt(3.0)) - 6;
  EXPECT_NEAR(found.share, 1 - (line * line - 1) / 8, 1e-6);
}

TEST(Start, HasNoWayToWhatIsNotFinite) {
  const Model m = locking_four_bar();
  for (const double bad : {NAN, INFINITY}) {
    for (const FoundStart& found : {find_start(held_at(m, {bad}), 0), find_start(m, bad)}) {
      EXPECT_EQ(found.stage, Stage::drivers);
      EXPECT_EQ(found.share, 0);
      for (const double q : found.q) EXPECT_TRUE(std::isfinite(q));
    }
  }
}

}  // namespace
}  // namespace desmo::start_test
