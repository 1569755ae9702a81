// Scenes on which earlier versions were wrong without a word, with the right answers: from closed
// forms, or from Newton's method in 40 digits and more.

#include "tests/accuracy/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "formulations/model/plan.h"
#include "formulations/modelling/measures/measures.h"
#include "formulations/verification/reference/reference.h"
#include "formulations/verification/run/live_run.h"
#include "tests/checked/driver_row.h"
#include "tests/checked/rows.h"
#include "tests/every_variant.h"

namespace desmo::scenes_test {
namespace {

using std::numbers::pi;

constexpr double degree = pi / 180;

/// A number of a row; row -1 is the last.
struct Answer {
  int row;
  const char* name;
  double value;
};

/// What a run of a scene is to end as. Answers are right to the digits with which they are known.
struct Asked {
  const char* scene;
  Outcome outcome = Outcome::converged;
  std::optional<RowFlag::Kind> first_flag{};
  std::vector<Answer> answers{};
  bool has_reference = false;  ///< all rows are compared with it
  std::vector<const char*> ids = {"global_automatic_klu", "group_automatic_lapack",
                                  "group_symbolic_explicit"};
  std::pair<double, double> misfit{};  ///< limits of the largest [m]; 0: there is none
};

void PrintTo(const Asked& asked, std::ostream* out) { *out << asked.scene; }

std::string scene_name(const testing::TestParamInfo<Asked>& info) { return info.param.scene; }

class EveryScene : public testing::TestWithParam<Asked> {};

TEST_P(EveryScene, HasTheRightAnswer) {
  const Asked& asked = GetParam();
  const Scene scene = scene_file(asked.scene);
  const Model whole = make_model(scene);
  const Plan plan = make_plan(whole, outputs_of(scene, whole), PlanExtent::left_out_equations);
  const Model& m = plan.model;
  for (const char* id : asked.ids) {
    SCOPED_TRACE(id);
    if (DESMO_SANITIZED && id != asked.ids.front()) break;
    const CheckedRows r = solve_checked(m, scene.grid, id, plan.level(), {.levels = plan.levels});
    const CheckedSummary& s = r.summary;
    EXPECT_EQ(s.outcome(), asked.outcome) << describe(s, m);
    EXPECT_EQ(s.first_flag.has_value(), asked.first_flag.has_value()) << describe(s, m);
    if (asked.first_flag && s.first_flag) EXPECT_EQ(s.first_flag->kind, *asked.first_flag);
    EXPECT_EQ(s.misfit.has_value(), asked.misfit.second > 0);
    if (s.misfit) {
      EXPECT_GE(s.misfit->amount, asked.misfit.first);
      EXPECT_LE(s.misfit->amount, asked.misfit.second);
    }
    if (asked.outcome == Outcome::failed) continue;
    ASSERT_EQ(s.instants, scene.grid.instants);
    for (const auto& [row, name, value] : asked.answers) {
      const auto& q = (row < 0 ? r.rows.back() : r.rows[row]).values.position;
      EXPECT_NEAR(q[m.coordinate(name)], value, 6e-12 * std::max(1., std::abs(value))) << name;
    }
    if (!asked.has_reference) continue;
    const Reference reference = make_reference(m, times_of(r.rows, 9));
    EXPECT_EQ(expect_within_radii(m, r.rows, reference.instants), std::ssize(reference.instants));
  }
}

const Asked asked[] = {
    {.scene = "arm_bucket_start_40",
     .answers = {{0, "b", 2.36835328104}, {0, "L.x", 1.25779265145}, {0, "L.y", 1.54771933342}}},
    {.scene = "arm_bucket_angle_turn", .answers = {{0, "b", 0.0994252534466}}},
    {.scene = "output_angle_185",
     .answers = {{0, "E.x", std::cos(185 * degree)},
                 {0, "E.y", std::sin(185 * degree)},
                 {0, "back", 5 * degree}}},
    {.scene = "goldberg_5r", .answers = {{0, "d", 2.76766927531}}},
    {.scene = "chain_false_branch", .has_reference = true},
    {.scene = "chain_false_branch_2", .has_reference = true},
    {.scene = "late_scale", .has_reference = true},
    {.scene = "scott_russell_tolerance",
     .has_reference = true,
     .ids = {"global_automatic_klu/tolerance:1e-15", "global_automatic_klu"}},
    {.scene = "bennett_folded_start", .answers = {{0, "d", 5}}},
    // Each pair of rods has its change points where the other is far from one.
    {.scene = "quartered_rods_start_200",
     .answers = {{0, "o", 200 * degree}, {-1, "o", 230 * degree}}},
    {.scene = "quartered_rods_request_o",
     .answers = {{0, "o", 200 * degree}, {-1, "o", 230 * degree}}},
    {.scene = "six_change_points",
     .outcome = Outcome::degraded,
     .first_flag = RowFlag::Kind::crossing,
     .answers = {{0, "o", 90 * degree}, {-1, "o", (90 + 1080 * 0.999) * degree}}},
    {.scene = "drawn_at_dead_centre", .outcome = Outcome::failed},
    // A third crank that is 2e-7 too long: 2e-7 (1 - cos 2.6) at the end.
    {.scene = "contradicting_crank",
     .outcome = Outcome::degraded,
     .first_flag = RowFlag::Kind::misfit,
     .misfit = {2.8e-7, 4.7e-7}},
    // Between rows, where it is stretched or folded, the digits open it by their square root.
    {.scene = "bennett_11_digits",
     .outcome = Outcome::degraded,
     .first_flag = RowFlag::Kind::misfit,
     .misfit = {1e-12, 5e-5}},
};

INSTANTIATE_TEST_SUITE_P(Table, EveryScene, testing::ValuesIn(asked), scene_name);

/// The start lies beyond a change point of the drawing.
TEST(ParallelogramStart, IsRightOrFlagged) {
  const Scene scene = scene_file("parallelogram_start_200");
  const Model m = make_model(scene);
  for (const Variant& v : tested_variants())
    for (const CheckedRow& row : solve_checked(m, scene.grid, v.id).rows)
      if (!row.flag)
        EXPECT_NEAR(row.values.position[m.coordinate("o")], (200 + 60 * row.time) * degree, 1e-12)
            << v.id;
}

/// A third crank, drawn 1e-7 away from its place, contradicts the others in every row. The change
/// point on the way from the drawing is named all the same.
TEST(ThirdCrankStart, NamesTheChangePointBesideTheMisfit) {
  const Scene scene = scene_file("third_crank_start_200");
  const Model m = make_model(scene);
  const CheckedRows r = solve_checked(m, scene.grid, "group_automatic_lapack");
  EXPECT_EQ(r.summary.crossings, 1) << describe(r.summary, m);
  for (const CheckedRow& row : r.rows) {
    ASSERT_TRUE(row.flag && row.flag->misfit);
    EXPECT_EQ(row.flag->kind, row.index == 0 ? RowFlag::Kind::crossing : RowFlag::Kind::misfit);
  }
  // So it is where drivers are handed in.
  const auto f = make_formulation(find_variant("group_automatic_lapack"), m);
  LiveRun run(*f);
  const LiveSummary s = run.step(DriverRow(m, 0));
  ASSERT_TRUE(s.flag && s.flag->misfit);
  EXPECT_EQ(s.flag->kind, RowFlag::Kind::crossing);
}

/// A delta robot 6e8 m from the origin, whose rods rounding makes contradict each other.
TEST(DeltaFar, IsFlagged) {
  const Scene scene = scene_file("delta_far_contradiction");
  const Model m = make_model(scene);
  for (const char* id : {"global_automatic_klu", "group_symbolic_explicit"})
    if (!DESMO_SANITIZED || std::string(id) == "global_automatic_klu")
      EXPECT_NE(solve_checked(m, scene.grid, id).summary.outcome(), Outcome::converged) << id;
}

/// A four-bar of millimetres on an arm of 1 or 10 km. The angle of the rocker from the arm is that
/// of the four-bar alone.
TEST(TinyOnHuge, IsRightToWhatRoundingOfTheArmLeaves) {
  for (const char* name : {"tiny_on_huge_1e6", "tiny_on_huge_1e7"}) {
    const Scene scene = scene_file(name);
    const Model m = make_model(scene);
    const auto at = [&](const char* point) {
      return std::ranges::find(scene.mechanism.points, point, &Mechanism::Point::name)->position;
    };
    // From A to D, along and across the arm.
    const auto a = at("A"), d = at("D");
    const double arm = std::hypot(a[0], a[1]), x = d[0] - a[0], y = d[1] - a[1];
    const double along = (a[0] * x + a[1] * y) / arm, across = (a[0] * y - a[1] * x) / arm;
    for (const char* id : {"global_automatic_klu", "group_automatic_lapack"}) {
      const CheckedRows r = solve_checked(m, scene.grid, id);
      EXPECT_EQ(r.summary.outcome(), Outcome::converged) << id << ": " << describe(r.summary, m);
      for (const CheckedRow& row : r.rows) {
        const double theta = 1 + 1.5 * row.time;
        const double bx = 0.001 * std::cos(theta) - along, by = 0.001 * std::sin(theta) - across;
        const double diagonal = std::hypot(bx, by);  // from D to B
        const double at_d =
            std::acos((diagonal * diagonal + 16e-6 - 9e-6) / (2 * 0.004 * diagonal));
        const double psi = std::atan2(by, bx) - at_d;
        EXPECT_NEAR(std::remainder(row.values.position[m.coordinate("psi")] - psi, 2 * pi), 0, 1e-9)
            << id << ", " << row.time;
      }
    }
  }
}

}  // namespace
}  // namespace desmo::scenes_test
