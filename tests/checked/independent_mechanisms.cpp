// Mechanisms that do not depend on each other, in one file: each is followed as if it stood alone.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <ostream>
#include <string>

#include "tests/checked/motions.h"

namespace desmo::independent_mechanisms_test {
namespace {

using std::numbers::pi;
using enum RowFlag::Kind;

// Motions of a crank, whose parallelogram is on its change point at π.
const Motion goes_on = Polynomial{{1, 0.3}}, passes = Polynomial{{pi - 0.5, 1.75}},
             begins = Polynomial{{pi, 1.75}}, begins_back = Polynomial{{pi, -1.25}},
             begins_from_rest = Polynomial{{pi, 0, 0, 1}}, stays = Polynomial{{pi}},
             rests_midway = Polynomial{{pi - 0.125, 0.75, -1.5, 1}},  // (t − 1/2)³ at 0.5 s
    turns_back_on_it = Polynomial{{pi - 0.25, 1, -1}},                // at 0.5 s
    turns_back_early = Polynomial{{pi - 0.16, 1.6, -4}},              // after 0.2 s
    turns_back_late = Polynomial{{pi - 0.625, 2.1, -1.764}};          // after 0.595 s

/// Comes to rest on the point after a while, and stays.
Motion comes_to_rest() { return shifted(make_spline(Trapezoid{0.3, 1, 8}), pi - 0.3); }

/// Rests on the point at first, then turns on.
Motion leaves_late() { return shifted(make_spline(Trapezoid{0.5, 1, 4, 0.4}), pi); }

/// A parallelogram of the scene: its drivers, and what a coordinate is in the closed form.
struct Bars {
  const char *crank, *pin, *joint;
  double radius, distance, x, y;  ///< m

  void expect_right(const Model& m, const CheckedRow& row, double angle, double near) const {
    const auto expect = [&](const std::string& name, double exact) {
      EXPECT_NEAR(m.value(name, row.values.position), exact, near) << name << ", " << row.time;
    };
    const std::string pin_name = pin, joint_name = joint;
    const double px = x + radius * std::cos(angle), py = y + radius * std::sin(angle);
    expect(pin_name + ".x", px), expect(pin_name + ".y", py);
    expect(joint_name + ".x", px + distance), expect(joint_name + ".y", py);
  }
};

constexpr Bars first{"theta", "B", "C", 0.01, 0.032, 0, 0},
    second{"alpha", "H", "K", 0.02, 0.048, 0, -0.04};

Model model_of(const Motion& theta, const Motion& alpha) {
  Scene scene = scene_file("two_parallelograms");
  scene.motions = {theta, alpha};
  return make_model(scene);
}

struct Both {
  const char* name;
  Motion theta, alpha;
};

void PrintTo(const Both& both, std::ostream* out) { *out << both.name; }

const Both all_pairs[] = {
    {"both begin", begins, begins},
    {"both begin, one back", begins, begins_back},
    {"both begin from rest", begins_from_rest, begins_from_rest},
    {"one begins, the other from rest", begins, begins_from_rest},
    {"both pass at once", passes, passes},
    {"both rest midway", rests_midway, rests_midway},
    {"both turn back at once", turns_back_on_it, turns_back_on_it},
    {"one passes while the other rests midway", Polynomial{{pi - 0.875, 1.75}}, rests_midway},
    {"one passes while the other turns back", Polynomial{{pi - 0.875, 1.75}}, turns_back_on_it},
    {"one stays, the other passes", stays, passes},
    {"one stays, the other turns back", stays, turns_back_on_it},
    {"one stays, the other begins", stays, begins},
    {"one stays, the other goes on", stays, goes_on},
    {"both stay", stays, stays},
    {"one begins, the other turns back later", begins, turns_back_late},
    {"one begins, the other passes later", begins, passes},
    {"one passes, the other turns back later", passes, turns_back_late},
    {"one turns back, the other passes later", turns_back_early, passes},
    {"one comes to rest, the other passes", comes_to_rest(), passes},
    {"both come to rest", comes_to_rest(), comes_to_rest()},
    {"one comes to rest, the other leaves", comes_to_rest(), leaves_late()},
    {"both leave", leaves_late(), leaves_late()},
};

constexpr const char* ids[] = {"group_automatic_lapack", "global_automatic_klu"};

class IndependentMechanisms : public testing::TestWithParam<Both> {};

/// Returns whether a motion leaves the point at once from where it starts.
bool leaves_point(const Motion& motion, const TimeGrid& grid) {
  const auto angle = [&](int i) { return sample(motion, grid.time(i)).position; };
  return angle(0) == pi && std::abs(angle(1) - pi) > 1e-6;
}

/// Returns the place of a row's flag, the worst first.
int rank(const CheckedRow& row) {
  constexpr std::array worst_first{unproven, branch, on_point, crossing, misfit};
  if (!row.flag) return 5;
  return static_cast<int>(std::ranges::find(worst_first, row.flag->kind) - worst_first.begin());
}

TEST_P(IndependentMechanisms, AreFollowedAsIfEachStoodAlone) {
  const auto& [name, theta, alpha] = GetParam();
  const TimeGrid grid = scene_file("two_parallelograms").grid;
  const Model both = model_of(theta, alpha), one = model_of(theta, goes_on),
              other = model_of(goes_on, alpha);
  for (const char* id : ids)
    for (const CheckOptions& options :
         {CheckOptions{}, CheckOptions{.mode = CheckMode::sample, .sample = 4}}) {
      const bool is_sample = options.mode == CheckMode::sample;
      if (is_sample && (DESMO_SANITIZED || id != ids[0])) continue;
      const auto solved = [&](const Model& m) {
        return solve_checked(m, grid, id, Level::acceleration, options);
      };
      const CheckedRows r = solved(both), a = solved(one), b = solved(other);
      SCOPED_TRACE(std::string(id) + ": " + describe(r.summary, both));
      ASSERT_EQ(std::ssize(r.rows), grid.instants);
      ASSERT_EQ(std::ssize(a.rows), grid.instants) << describe(a.summary, one);
      ASSERT_EQ(std::ssize(b.rows), grid.instants) << describe(b.summary, other);
      EXPECT_NE(r.summary.outcome(), Outcome::failed);
      EXPECT_EQ(r.summary.crossings, a.summary.crossings + b.summary.crossings);
      for (int i = 0; i < grid.instants; ++i) {
        const CheckedRow& row = r.rows[i];
        const int expected = std::min(rank(a.rows[i]), rank(b.rows[i]));
        EXPECT_GE(rank(row), 2) << row.time;
        EXPECT_EQ(rank(row), expected) << row.time;
        for (const auto& [bars, alone, motion] :
             {std::tuple(&first, &a.rows[i], &theta), std::tuple(&second, &b.rows[i], &alpha)}) {
          const bool is_on_point = alone->flag && alone->flag->kind == on_point;
          if (leaves_point(*motion, grid)) {
            EXPECT_EQ(alone->flag.has_value(), i == 0) << row.time;
            EXPECT_EQ(is_on_point, i == 0) << row.time;
          }
          bars->expect_right(both, row, sample(*motion, row.time).position,
                             is_on_point ? 1e-7
                             : is_sample ? 1e-9
                                         : 1e-12);
          if (is_on_point || row.radius.velocity.empty() || alone->radius.velocity.empty())
            continue;
          const int x = both.coordinate(std::string(bars->joint) + ".x");
          for (const Level level : all_levels)
            EXPECT_NEAR(row.values[level][x], alone->values[level][x],
                        row.radius[level][x] + alone->radius[level][x])
                << row.time;
        }
      }
    }
}

/// The first mechanism locks on the way from its drawing to 5.2 rad; the other one rests on its
/// point.
TEST(IndependentMechanism, WithoutRatesIsSaidBesideAWorseFlag) {
  Scene scene = scene_file("two_parallelograms");
  scene.motions = {Polynomial{{5.2, 0.3}}, stays};
  for (Mechanism::Point& p : scene.mechanism.points) {
    if (p.name == "C") p.position = {0.036, 0.012, 0};
    if (p.name == "D") p.position = {0.042, 0, 0};
  }
  const Model m = make_model(scene);
  const int on = m.coordinate("K.x"), off = m.coordinate("C.x");
  RowCount rows;
  CheckOptions options;
  options.checked = [&](const CheckedInstant& row) {
    ASSERT_TRUE(row.flag && row.other_flags.size() == 1) << row.instant.time;
    EXPECT_EQ(row.flag->kind, branch);
    EXPECT_EQ(row.other_flags[0].kind, on_point);
    EXPECT_NE(row.flag->group, row.other_flags[0].group);
    EXPECT_TRUE(row.is_on_point);
    EXPECT_EQ(row.relative_radius.position, INFINITY);
    EXPECT_TRUE(std::isnan(row.instant.qd[on]) && std::isfinite(row.instant.qd[off]));
  };
  const auto f = make_formulation(find_variant(ids[0]), m);
  const TimeGrid grid = scene_file("two_parallelograms").grid;
  const CheckedSummary s = run_checked(*f, grid, {Level::acceleration}, rows, options);
  EXPECT_EQ(s.flagged, grid.instants);
  EXPECT_EQ(s.crossings, 1);
  ASSERT_TRUE(s.first_flag && s.first_crossing);
  EXPECT_EQ(s.first_flag->kind, branch);
}

INSTANTIATE_TEST_SUITE_P(Pairs, IndependentMechanisms, testing::ValuesIn(all_pairs));

}  // namespace
}  // namespace desmo::independent_mechanisms_test
