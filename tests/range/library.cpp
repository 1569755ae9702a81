// Ranges of the library's mechanisms, against bisection in quadruple precision and closed forms.

#include "cases/library/library.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "formulations/model/characteristic_lengths.h"
#include "formulations/model/scales.h"
#include "formulations/verification/condition.h"
#include "formulations/verification/reference/global_solver.h"
#include "formulations/verification/reference/wide_instant.h"
#include "tests/mechanisms.h"
#include "tests/range/solved_start.h"

namespace desmo::library_range_test {
namespace {

constexpr double pi = std::numbers::pi;

/// Follows one driver from a position at 1 rad or unit of length a second, by all equations at
/// once, first in double precision in steps of 10 ms, then in quadruple precision.
class Follower {
 public:
  Follower(Model model, const std::vector<double>& q, int driver, double direction)
      : m_(std::move(model)) {
    m_.estimate = q;
    for (int d = 0; d < m_.degrees_of_freedom(); ++d) {
      const double start = q[m_.entities[m_.drivers[d].coordinate].first];
      m_.drivers[d].motion = Polynomial{{start, d == driver ? direction : 0}};
    }
  }

  /// Moves a solver to the solution at a distance of the driver.
  void follow_to(double distance, GlobalSolver<Quadruple>& solver) const {
    GlobalSolver<double> walker(m_);
    const int steps = static_cast<int>(std::ceil(distance / 0.01)) + 1;
    for (int i = 0; i <= steps; ++i) walker.solve_positions(distance * i / steps);
    solver.start_at(walker);
    solver.solve_positions(distance);
  }

  /// Returns the distance beyond which no position is found next to the last one, by bisection.
  double limit(double solved, double unsolved) const {
    GlobalSolver<Quadruple> last(m_);
    follow_to(solved, last);
    while (unsolved - solved > 1e-15) {
      const double middle = (solved + unsolved) / 2;
      if (middle == solved || middle == unsolved) break;
      GlobalSolver<Quadruple> trial(m_);
      trial.start_at(last);
      if (!solves(trial, middle, last)) {
        unsolved = middle;
        continue;
      }
      solved = middle;
      last.start_at(trial);
    }
    return (solved + unsolved) / 2;
  }

  std::vector<double> q_at(double distance) const {
    GlobalSolver<Quadruple> solver(m_);
    follow_to(distance, solver);
    const std::vector<Quadruple> q = solver.q();
    return {q.begin(), q.end()};
  }

 private:
  static bool solves(GlobalSolver<Quadruple>& trial, double distance,
                     const GlobalSolver<Quadruple>& last) {
    try {
      trial.solve_positions(distance);
    } catch (const std::runtime_error&) {
      return false;
    }
    const auto q = trial.q(), before = last.q();
    for (std::size_t i = 0; i < q.size(); ++i)
      if (!(abs(q[i] - before[i]) < 0.3)) return false;  // another branch
    return true;
  }

  Model m_;
};

struct Found {
  Model m;
  std::vector<double> q;
  std::vector<DriverRange> ranges;
};

Found found(const std::string& name) {
  Found f{make_model(library_scene(name)), {}, {}};
  f.q = solved_start(f.m);
  for (int d = 0; d < f.m.degrees_of_freedom(); ++d) f.ranges.push_back(find_range(f.m, f.q, d));
  return f;
}

class Locks : public testing::TestWithParam<const char*> {};

TEST_P(Locks, AreWhereQuadruplePrecisionEnds) {
  const Found f = found(GetParam());
  int locks = 0;
  for (int d = 0; d < f.m.degrees_of_freedom(); ++d) {
    const DriverRange& r = f.ranges[d];
    const EntityId driver = f.m.drivers[d].coordinate;
    const double scale =
        is_length(f.m.entities[driver].kind) ? CharacteristicLengths(f.m).of(driver) : 1;
    for (const auto& [end, direction] : {std::pair(&r.down, -1.0), std::pair(&r.up, 1.0)}) {
      if (end->stop == RangeStop::full_turn) continue;
      ASSERT_EQ(end->stop, RangeStop::dead_point) << f.m.entities[driver].name;
      const double distance = direction * (end->value - r.start);
      const Follower follower(f.m, f.q, d, direction);
      const double limit = follower.limit(distance - 1e-5, distance + 1e-5);
      EXPECT_LT(std::abs(limit - distance), 1e-9 * scale);
      EXPECT_GE(direction * (end->beyond - r.start), limit - 1e-15);
      EXPECT_LT(std::abs(end->beyond - end->value), 1e-9 * scale);
      EXPECT_EQ(end->groups.size(), 1u);
      EXPECT_FALSE(end->moving.empty());
      EXPECT_FALSE(end->constraints.empty());
      ++locks;
    }
  }
  EXPECT_GT(locks, 0);
}

INSTANTIATE_TEST_SUITE_P(Library, Locks,
                         testing::Values("inverted_slider_crank", "double_wishbone", "macpherson",
                                         "truck_axle", "stewart", "delta"),
                         [](const auto& mechanism) { return std::string(mechanism.param); });

class FullTurns : public testing::TestWithParam<const char*> {};

TEST_P(FullTurns, ComeBackInQuadruplePrecision) {
  const Found f = found(GetParam());
  ASSERT_EQ(f.m.degrees_of_freedom(), 1);
  const DriverRange& r = f.ranges[0];
  for (const RangeEnd* end : {&r.down, &r.up}) {
    EXPECT_EQ(end->stop, RangeStop::full_turn);
    EXPECT_EQ(end->turns, 1);
    EXPECT_NEAR(std::abs(end->value - r.start), 2 * pi, 1e-12);
  }
  EXPECT_TRUE(r.change_points.empty());
  const Follower follower(f.m, f.q, 0, 1);
  const auto first = follower.q_at(0), last = follower.q_at(2 * pi);
  const std::vector<EntityId> owner = entity_of_coordinate(f.m);
  for (std::size_t i = 0; i < first.size(); ++i) {
    double change = last[i] - first[i];
    if (f.m.entities[owner[i]].kind == EntityKind::angle) change = std::remainder(change, 2 * pi);
    EXPECT_LT(std::abs(change), 1e-12) << f.m.entities[owner[i]].name;
  }
}

INSTANTIATE_TEST_SUITE_P(Library, FullTurns,
                         testing::Values("slider_crank", "whitworth", "rssr", "watt_six_bar",
                                         "stephenson_six_bar", "jansen_leg", "andrews"),
                         [](const auto& mechanism) { return std::string(mechanism.param); });

TEST(LibraryRange, OfTheCylinderIsSumAndDifferenceOfTheBoomsSides) {
  const Found f = found("inverted_slider_crank");
  const double boom = std::sqrt(0.9), base = 0.5;
  EXPECT_NEAR(f.ranges[0].down.value, boom - base, 1e-14);
  EXPECT_NEAR(f.ranges[0].up.value, boom + base, 1e-14);
}

TEST(LibraryRange, OfAnAxleIsTheSameInTheWholeTruck) {
  const Found axle = found("truck_axle");
  const Model truck = truck_model(5);
  const std::vector<double> q = solved_start(truck);
  for (int d = 0; d < 2; ++d) {
    const DriverRange r = find_range(truck, q, d);
    EXPECT_NEAR(r.down.value, axle.ranges[d].down.value, 1e-10);
    EXPECT_NEAR(r.up.value, axle.ranges[d].up.value, 1e-10);
    ASSERT_EQ(r.up.groups.size(), 1u);
    EXPECT_EQ(truck.groups[r.up.groups[0]].name,
              "axle1/" + axle.m.groups[axle.ranges[d].up.groups.at(0)].name);
  }
}

TEST(LibraryRange, ChangePointsOfTheDeltaRobotAreSingular) {
  const Found f = found("delta");
  int passed = 0;
  for (int d = 0; d < 3; ++d)
    for (const ChangePoint& c : f.ranges[d].change_points) {
      const double distance = c.value - f.ranges[d].start;
      const Follower follower(f.m, f.q, d, distance > 0 ? 1 : -1);
      const auto condition_before = [&](double by) {
        return ConditionNumber(f.m)(follower.q_at(std::abs(distance) - by));
      };
      // It grows as one over the distance. Nearer, rounding of dimensions opens the crossing.
      EXPECT_NEAR(condition_before(1e-7) / condition_before(1e-6), 10, 0.2);
      EXPECT_GT(c.group, 0);
      ++passed;
    }
  EXPECT_EQ(passed, 3);
}

}  // namespace
}  // namespace desmo::library_range_test
