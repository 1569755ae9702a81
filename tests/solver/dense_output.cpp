// Instants between those solved: exact where theory says so, and solved ones as they were.

#include "formulations/motion/dense_output.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "formulations/motion/internals.h"
#include "tests/dead_point.h"
#include "tests/formulated.h"
#include "tests/mechanisms.h"

namespace desmo::dense_output_test {
namespace {

using Levels = PerLevel<std::vector<double>>;  // q, q̇, q̈

struct Kept {
  double time = 0;
  Levels values{};
  long updates = 0;
  bool interpolated = false;
  bool operator==(const Kept&) const = default;
};

/// Everything that comes, in the order in which it does.
class Everything final : public Observer {
 public:
  Flow observe(const Instant& i) noexcept override {
    EXPECT_EQ(i.index, static_cast<int>(all.size()));
    const PerLevel<std::span<const double>> given{i.q, i.qd, i.qdd};
    all.push_back({i.time, {}, i.updates, i.interpolated});
    for (const Level level : all_levels)
      all.back().values[level].assign(given[level].begin(), given[level].end());
    return Flow::go_on;
  }
  std::vector<Kept> all;
};

struct Solution {
  Summary summary;
  std::vector<Kept> all;
};

Solution run(const std::string& id, const Model& m, const TimeGrid& grid,
             const Request& request = {}) {
  Everything observer;
  const Summary summary = formulated(id, m)->run(grid, request, observer);
  return {summary, std::move(observer.all)};
}

/// A quintic is its own interpolant, whatever the grid. So positions, velocities and accelerations
/// have the orders 6, 5 and 4.
TEST(DenseOutput, IsExactOnAQuintic) {
  const auto at = [](int index, double t, std::vector<double>& values) {
    values = {1 + t * (2 + t * (-3 + t * (4 + t * (-5 + 6 * t)))),
              2 + t * (-6 + t * (12 + t * (-20 + 30 * t))), -6 + t * (24 + t * (-60 + 120 * t))};
    return Instant{index, t, std::span(values).subspan(0, 1), std::span(values).subspan(1, 1),
                   std::span(values).subspan(2, 1)};
  };
  const TimeGrid grid{0.3, 0.1, 12};
  Everything observer;
  DenseOutput all(grid, 4, {}, 1, observer);
  std::vector<double> values;
  for (int i = 0; i < 4; ++i)  // 0, 4, 8 and 11
    all.observe(at(i, grid.time(std::min(4 * i, 11)), values));
  EXPECT_EQ(all.delivered(), 12);
  ASSERT_EQ(observer.all.size(), 12u);
  for (const auto& [time, kept, updates, interpolated] : observer.all) {
    at(0, time, values);
    EXPECT_NEAR(kept.position[0], values[0], 1e-13) << time;
    EXPECT_NEAR(kept.velocity[0], values[1], 1e-12) << time;
    EXPECT_NEAR(kept.acceleration[0], values[2], 1e-11) << time;
  }
}

/// Also where a stride is no power of two and steps are no binary fractions.
TEST(DenseOutput, HandsOnSolvedInstantsAsTheyAre) {
  const Model m = truck_model(1);
  for (const int stride : {2, 3, 7, 16})
    for (const int instants : {1, 2, stride, stride + 1, 10 * stride + 1, 10 * stride + 2}) {
      const TimeGrid grid{0.1, 0.003, instants};
      const Solution coarse = run("group_symbolic_klu", m, grid.every(stride)),
                     every = run("group_symbolic_klu", m, grid),
                     all = run("group_symbolic_klu/stride:" + std::to_string(stride), m, grid);
      ASSERT_TRUE(all.summary.ok());
      EXPECT_EQ(all.summary.instants, instants);
      ASSERT_EQ(all.all.size(), static_cast<std::size_t>(instants));
      for (std::size_t i = 0; i < coarse.all.size(); ++i)
        EXPECT_EQ(all.all[i * stride], coarse.all[i]) << stride << ' ' << i;
      EXPECT_FALSE(all.all.back().interpolated);
      for (int i = 0; i < instants; ++i) EXPECT_EQ(all.all[i].time, every.all[i].time);
    }
}

TEST(DenseOutput, EndsWithTheLastInstantSolved) {
  const Model m = truck_model(1);
  const TimeGrid grid{0, 0.01, 24};  // 0, 8, 16 and 23
  const Solution every = run("group_symbolic_klu", m, grid),
                 some = run("group_symbolic_klu/stride:8", m, grid);
  const auto solved = std::ranges::count(some.all, false, &Kept::interpolated);
  EXPECT_EQ(solved, 4);
  EXPECT_LT(max_difference(some.all[23].values.acceleration, every.all[23].values.acceleration),
            1e-7);
  long updates = 0;
  for (const Kept& kept : some.all) updates += kept.updates;
  EXPECT_EQ(updates, some.summary.updates);
  EXPECT_LT(some.summary.iterations, every.summary.iterations);
  EXPECT_EQ(some.summary.time, grid.time(23));
}

/// The same holds where instants are interpolated and where all are solved.
TEST(DenseOutput, HasWhatIsAskedFor) {
  const Model m = truck_model(1);
  const TimeGrid grid{0, 0.01, 50};
  const std::vector<int> asked{2, m.coordinates() - 1, 5, 6};
  for (const char* id : {"group_symbolic_inlined/stride:4", "group_symbolic_inlined"}) {
    const Solution everything = run(id, m, grid);
    for (const Level highest : all_levels) {
      const Solution some = run(id, m, grid, {highest, asked});
      ASSERT_EQ(some.all.size(), everything.all.size());
      for (std::size_t i = 0; i < some.all.size(); ++i)
        for (const Level level : all_levels) {
          const auto &a = some.all[i].values[level], &b = everything.all[i].values[level];
          ASSERT_EQ(a.empty(), level > highest);
          if (a.empty()) continue;
          for (const int k : asked) EXPECT_EQ(a[k], b[k]);
        }
    }
  }
}

/// Positions between take the accelerations of those solved, whatever is asked.
TEST(DenseOutput, NeedsEveryLevelOfEveryPart) {
  const Model m = truck_model(1);
  const TimeGrid grid{0, 0.01, 50};
  const auto f = formulated("group_symbolic_eigen/stride:4", m);
  f->solve_only(std::vector(m.coordinates(), Level::position));
  Everything observer;
  ASSERT_TRUE(f->run(grid, {Level::position}, observer).ok());
  const Solution expected = run("group_symbolic_eigen/stride:4", m, grid);
  for (std::size_t i = 0; i < observer.all.size(); ++i)
    EXPECT_EQ(observer.all[i].values.position, expected.all[i].values.position) << i;
}

/// Segments of the motion come in any order, and parts on lanes; what is between comes in order.
TEST(DenseOutput, GoesWithSegmentsAndLanes) {
  const Model m = truck_model(2);
  const TimeGrid grid{0, 0.005, 402};
  const std::string id = "group_symbolic_explicit";
  const Solution by_steps = run(id + "/stride:4", m, grid);
  ASSERT_TRUE(by_steps.summary.ok());
  for (const std::string how : {"/segments:4", "/lanes:4", "/threads:2", "/segments:4/threads:2"}) {
    const auto f = formulated(id + how + "/stride:4", m);
    Everything observer;
    const Summary s = f->run(grid, {}, observer);
    ASSERT_TRUE(s.ok());
    EXPECT_EQ(s.instants, grid.instants);
    EXPECT_EQ(stepping_of(*f).runs_without_segments(), 0);
    ASSERT_EQ(observer.all.size(), by_steps.all.size());
    for (std::size_t i = 0; i < observer.all.size(); ++i) {
      const Kept &a = observer.all[i], &b = by_steps.all[i];
      EXPECT_EQ(a.interpolated, b.interpolated) << i;
      EXPECT_LT(max_difference(a.values.position, b.values.position), 1e-9) << how << i;
      EXPECT_LT(max_difference(a.values.acceleration, b.values.acceleration), 1e-4) << how << i;
    }
  }
}

/// The coupler is too short where the crank points away: up to the last solved, all is there.
TEST(DenseOutput, StopsBehindTheLastInstantSolved) {
  const Model m = locking_four_bar();
  const TimeGrid grid{0, 0.01, 300};
  const Solution coarse = run("group_automatic_eigen", m, grid.every(8)),
                 all = run("group_automatic_eigen/stride:8", m, grid);
  ASSERT_FALSE(coarse.summary.ok());
  ASSERT_GT(coarse.summary.instants, 2);
  EXPECT_EQ(all.summary.status, coarse.summary.status);
  EXPECT_EQ(all.summary.time, coarse.summary.time);
  EXPECT_EQ(all.summary.group, coarse.summary.group);
  EXPECT_EQ(all.summary.constraint, coarse.summary.constraint);
  EXPECT_EQ(all.summary.instants, 8 * (coarse.summary.instants - 1) + 1);
  EXPECT_EQ(all.all.size(), static_cast<std::size_t>(all.summary.instants));
}

TEST(DenseOutput, LeavesSingleStepsAlone) {
  const Model m = four_bar_model(2);
  const auto f = formulated("group_automatic_eigen/stride:8", m),
             g = formulated("group_automatic_eigen", m);
  for (const double t : {0.0, 0.01, 0.02}) {
    ASSERT_TRUE(f->step(t).ok() && g->step(t).ok());
    EXPECT_TRUE(are_at_one_instant(*f, *g)) << t;
  }
}

}  // namespace
}  // namespace desmo::dense_output_test
