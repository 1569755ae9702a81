// How exact checked rows are, whatever formulation solved them, and what is said of it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include "formulations/verification/condition.h"
#include "formulations/verification/reference/reference.h"
#include "tests/accuracy/scenes.h"
#include "tests/checked/rows.h"
#include "tests/dead_point.h"
#include "tests/every_variant.h"

namespace desmo::exactness_test {
namespace {

constexpr double u = 0x1p-53;

/// A motion with its exact numbers.
struct Known {
  Known(Model model, const TimeGrid& g, int count)
      : m(std::move(model)), grid(g), reference(make_reference(m, sampled(g, count))) {
    ConditionNumber number(m);
    for (const ReferenceInstant& i : reference.instants) condition.push_back(number(i.q));
  }
  Model m;
  TimeGrid grid;
  Reference reference;
  std::vector<double> condition;  // of each instant
};

const std::vector<Known>& few_motions() {
  static const std::vector<Known> all = [] {
    std::vector<Known> result;
    for (const char* name : {"slider_crank", "rssr", "stephenson_six_bar"}) {
      const Scene scene = library_scene(name);
      result.emplace_back(make_model(scene), TimeGrid{scene.grid.start, scene.grid.step, 17}, 5);
    }
    return result;
  }();
  return all;
}

/// Solves a motion. Expects errors of positions below (1 + 5e-4 κ) u and of rates below
/// (1 + 2e-4 κ²) u, relative to the scale or, where that is more, to the number.
void expect_exact(const Known& known, const std::string& id) {
  SCOPED_TRACE(id);
  const CheckedRows r = solve_checked(known.m, known.grid, id);
  EXPECT_EQ(r.summary.outcome(), Outcome::converged) << describe(r.summary, known.m);
  const Scales& scales = known.reference.scales;
  for (std::size_t k = 0; k < known.reference.instants.size(); ++k) {
    const ReferenceInstant& exact = known.reference.instants[k];
    const auto row = std::ranges::find(r.rows, exact.time, &CheckedRow::time);
    ASSERT_NE(row, r.rows.end());
    const double condition = known.condition[k];
    for (const Level level : all_levels)
      for (const Entity& e : known.m.entities)
        for (int i = e.first; !e.fixed && i < e.first + e.size; ++i) {
          const double x = row->values[level][i];
          const double digits =
              level == Level::position ? 5e-4 * condition : 2e-4 * condition * condition;
          EXPECT_LE(error_of(x, exact, level, i),
                    (1 + digits) * u * std::max(scales.of(e.kind, level), std::abs(x)))
              << known.m.name << ", " << e.name << ", level " << static_cast<int>(level) << ", "
              << exact.time << " s, condition " << condition;
        }
  }
}

EVERY_VARIANT(ExactFormulation);

TEST_P(ExactFormulation, DeliversTheSameNumbersToTheLastDigits) {
  for (const Known& known : few_motions())
    for (const char* tolerance : {"1e-4", "1e-8", "1e-12"}) {
      expect_exact(known, GetParam().id + "/tolerance:" + tolerance);
      if (DESMO_SANITIZED) break;
    }
}

/// Settings that leave the formulation's numbers rough, or interpolated.
TEST(Exactness, IsThatOfTheProofWhateverTheSettings) {
  for (const Known& known : few_motions())
    for (const char* id :
         {"global_automatic_lapack/iterations:1", "group_automatic_klu/iterations:1",
          "global_automatic_klu/jacobian:step", "block_automatic_klu/guess:hermite5/stride:4",
          "group_symbolic_explicit/stride:16"})
      expect_exact(known, id);
}

void expect_radii(const Known& known, const std::string& id) {
  SCOPED_TRACE(known.m.name + ", " + id);
  const CheckedRows r = solve_checked(known.m, known.grid, id);
  EXPECT_EQ(r.summary.outcome(), Outcome::converged) << describe(r.summary, known.m);
  EXPECT_EQ(expect_within_radii(known.m, r.rows, known.reference.instants),
            std::ssize(known.reference.instants));
  for (const Level level : all_levels)
    for (const CheckedRow& row : r.rows)
      for (const Entity& e : known.m.entities)
        for (int i = e.first; !e.fixed && i < e.first + e.size; ++i)
          ASSERT_LE(row.radius[level][i],
                    r.summary.radius[level] * r.summary.scales.of(e.kind, level) * (1 + 1e-15));
}

TEST(Radii, HoldNextToADeadPoint) {
  for (double distance = 1e-2; distance > 0.9e-10; distance /= 100) {
    const Known known(locking_four_bar(Polynomial{{dead_point - distance, -1}}),
                      {0, distance / 64, 9}, 9);
    for (const char* id : {"global_automatic_klu", "block_symbolic_inlined"})
      expect_radii(known, id);
  }
}

/// Where the crank points at the block, pivots of another position give rates no digit.
TEST(Radii, HoldWherePivotsAreThoseOfAnotherPosition) {
  const Scene scene = scene_file("oscillating_block");
  const Known known(make_model(scene), scene.grid, DESMO_SANITIZED ? 21 : 201);
  for (const char* id : {"global_automatic_klu", "group_automatic_klu", "block_automatic_klu"})
    expect_radii(known, id);
}

TEST(Radii, ArePrintedRoundedUp) {
  CheckedSummary s;
  for (const double bound : {1.0488e-14, 1e-14, 9.96e-9, 3.0000001e-16, 0.0, 2.5e-310})
    for (const Level level : all_levels) {
      s.level = level;
      s.radius = {bound, 1.04 * bound, 2 * bound};
      PerLevel<double> printed;
      const int levels =
          std::sscanf(describe_radius(s).c_str(),
                      "condition %*f, errors at most %lf, %lf in velocity, %lf in acceleration",
                      &printed.position, &printed.velocity, &printed.acceleration);
      ASSERT_EQ(levels, 1 + static_cast<int>(level));
      for (const Level l : std::span(all_levels).first(levels)) {
        EXPECT_GE(printed[l], s.radius[l]);
        EXPECT_LE(printed[l], s.radius[l] * 1.12 + 1e-323);
      }
    }
}

}  // namespace
}  // namespace desmo::exactness_test
