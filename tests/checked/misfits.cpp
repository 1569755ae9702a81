// Misfits of equations that were left out: which of them a flag and a summary name, and when they
// call for other equations.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "formulations/model/misfit.h"
#include "formulations/modelling/independence/linearisation.h"
#include "formulations/motion/groupwise/double_solution.h"
#include "formulations/verification/run/follower.h"
#include "formulations/verification/run/row_tally.h"
#include "tests/certificate/containment.h"
#include "tests/checked/rows.h"
#include "tests/dead_point.h"
#include "tests/everything.h"
#include "tests/overconstrained.h"

namespace desmo::misfits_test {
namespace {

/// Where Bennett's linkage of five digits is nearly stretched, the equations that are kept leave
/// more and more of the others: 9e-5 of their length at 2.12 s, 1e-4 at 2.14 s, 5e-4 at 2.3 s. From
/// 1e-4 on, other equations are taken, by which 2e-5 are left. If they were taken from 1e-5 on,
/// rows from 2.02 s on would be off the kept equations by digits of the file; from 1e-3 on, rows
/// would be off the others by more than modelling accepts of a drawing.
TEST(Misfits, AboveThoseOfADrawingCallForOtherEquations) {
  const Model m = make_model(bennett(0.8L, 5));
  const TimeGrid grid{0, 0.02, 116};
  const char* const id = "global_automatic_klu";
  const CheckedRows checked = solve_checked(m, grid, id);
  ASSERT_EQ(checked.summary.instants, grid.instants) << describe(checked.summary, m);
  Everything kept(grid.instants);
  ASSERT_TRUE(make_formulation(find_variant(id), m)->run(grid, {}, kept).ok());
  double off_kept = 0;  // of the rows at which the kept equations leave less
  for (const CheckedRow& row : checked.rows) {
    ASSERT_TRUE(row.flag && row.flag->misfit) << row.time;
    EXPECT_EQ(row.flag->kind, RowFlag::Kind::misfit) << row.time;
    EXPECT_LE(row.flag->misfit->relative, max_misfit) << row.time;
    for (int i = 0; row.time < 2.13 && i < m.coordinates(); ++i)
      off_kept =
          std::max(off_kept, std::abs(row.values.position[i] - kept.all.at(row.index).at(i)));
  }
  EXPECT_LE(off_kept, 1e-9);
}

/// Misfits of different units: each is larger than the other in one of the two numbers.
constexpr Misfit of_length{0, 1e-9, EntityKind::distance, 1e-6};
constexpr Misfit of_angle{1, 1e-7, EntityKind::angle, 1e-7};

/// If amounts were compared, 1e-7 rad would count as more than 1e-9 m of a millimetre.
TEST(Misfits, OfRowsCompareOverTheirLengthsInASummary) {
  const Model m = locking_four_bar(Polynomial{{1, 2}});
  const std::vector<double> zero(m.coordinates());
  for (const bool angle_first : {true, false}) {
    RowTally tally(m, {0, 0.1, 11});
    CheckedSummary summary;
    for (const bool is_first : {true, false}) {
      CheckedInstant row{.instant = instant_of(0, {zero, zero, zero}),
                         .radius = {zero, zero, zero}};
      row.flag = {.kind = RowFlag::Kind::misfit,
                  .misfit = is_first == angle_first ? of_angle : of_length};
      tally.take(row, summary);
    }
    EXPECT_EQ(summary.flagged, 2);
    ASSERT_TRUE(summary.misfit);
    EXPECT_EQ(summary.misfit->kind, EntityKind::distance) << angle_first;
  }
}

/// A flag names the misfit of its row, a length, or that of the way to it, an angle here: the one
/// that is larger over its length. If amounts were compared, it would be the other one both times.
TEST(Misfits, OfARowAndOfTheWayToItCompareOverTheirLengths) {
  const Model m = make_model(parallel_cranks(1.1L, 17, true, 1e-8));
  Follower follower(nullptr, m, {});
  const ReferenceInstant solved = double_solution(m, std::vector{0.5}).front();
  const RefinedInstant& row = follower.refinement.refine(instant_of(solved));
  const std::optional<Misfit> here = follower.left_out.check(row);
  ASSERT_TRUE(here && is_length(here->kind));
  for (const bool is_worse : {true, false}) {
    const double larger = is_worse ? 10 : 0.1;
    const Misfit on_the_way{here->constraint, here->amount / larger, EntityKind::angle,
                            here->relative * larger};
    follower.left_out.note(LeftOutEquations::Between{on_the_way, 0.3});
    std::optional<RowFlag> flag;
    follower.flag_misfit(row, flag);
    ASSERT_TRUE(flag && flag->misfit);
    EXPECT_EQ(flag->kind, RowFlag::Kind::misfit);
    EXPECT_EQ(is_length(flag->misfit->kind), !is_worse);
    EXPECT_EQ(flag->after, is_worse ? 0.3 : 0.5);
    EXPECT_FALSE(follower.left_out.between());  // no way leads to two rows
  }
}

}  // namespace
}  // namespace desmo::misfits_test
