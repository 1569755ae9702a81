// Every mechanism of the library, started anywhere in its motion and solved with any stride.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "formulations/id.h"
#include "formulations/verification/error.h"
#include "formulations/verification/monitor/monitored_run.h"
#include "formulations/verification/reference/reference.h"
#include "tests/accuracy/scenes.h"
#include "tests/discard.h"

namespace desmo::library_test {
namespace {

MonitoredSummary run(const Model& m, const TimeGrid& grid, const std::string& id,
                     Observer& observer) {
  const Configuration c = parse_id(id);
  return run_monitored(*make_formulation(*c.variant, m, c.settings), grid, {}, observer);
}

/// Keeps the positions of all instants.
class Positions final : public Observer {
 public:
  Flow observe(const Instant& i) noexcept override {
    all.emplace_back(i.q.begin(), i.q.end());
    return Flow::go_on;
  }
  std::vector<std::vector<double>> all;
};

/// Returns the largest difference of two positions but for whole turns, relative to the scales.
double difference(const Model& m, const Scales& scales, const std::vector<double>& a,
                  const std::vector<double>& b) {
  double largest = 0;
  for (const Entity& e : m.entities)
    for (int i = e.first; !e.fixed && i < e.first + e.size; ++i) {
      const double off = e.kind == EntityKind::angle
                             ? std::remainder(a[i] - b[i], 2 * std::numbers::pi)
                             : a[i] - b[i];
      largest = std::max(largest, std::abs(off) / scales.of(e.kind, Level::position));
    }
  return largest;
}

using Named = std::tuple<std::string, std::string>;  // a mechanism and an id

std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const LibraryMechanism& l : library()) result.emplace_back(l.name);
  return result;
}

std::string test_name(const testing::TestParamInfo<Named>& info) {
  std::string name = std::get<0>(info.param) + "_" + std::get<1>(info.param);
  std::ranges::replace_if(
      name, [](char c) { return !std::isalnum(c); }, '_');
  return name;
}

class Starts : public testing::TestWithParam<Named> {};

/// A start far from the nominal position is where the motion that begins there comes to.
TEST_P(Starts, LieOnTheBranchThatTheNominalPositionLeadsTo) {
  const auto& [name, id] = GetParam();
  const Scene scene = library_scene(name);
  const Model m = make_model(scene);
  Positions whole;
  const MonitoredSummary all = run(m, scene.grid, id, whole);
  ASSERT_EQ(all.outcome(), Outcome::converged);
  for (int eighth = 1; eighth < 8; ++eighth) {
    const int first = eighth * (scene.grid.instants - 1) / 8;
    Positions from;
    const MonitoredSummary s = run(m, {scene.grid.time(first), scene.grid.step, 2}, id, from);
    ASSERT_EQ(s.outcome(), Outcome::converged) << first;
    EXPECT_LE(difference(m, s.scales, from.all[0], whole.all[first]),
              s.bound.position + all.bound.position)
        << first;
  }
}

INSTANTIATE_TEST_SUITE_P(Library, Starts,
                         testing::Combine(testing::ValuesIn(names()),
                                          testing::Values("global_automatic_klu",
                                                          "block_automatic_lapack",
                                                          "group_symbolic_explicit")),
                         test_name);

class Strides : public testing::TestWithParam<Named> {};

TEST_P(Strides, GiveRowsThatAreRightToTheBoundsStated) {
  const auto& [name, id] = GetParam();
  const Scene scene = library_scene(name);
  const Model m = make_model(scene);
  const Reference reference = make_reference(m, sampled(scene.grid, 14));
  ErrorMeasure measure(m, reference.instants, reference.scales);
  const MonitoredSummary s = run(m, scene.grid, id, measure);
  EXPECT_EQ(s.outcome(), Outcome::converged);
  const SolutionError error = measure.error();
  EXPECT_EQ(error.instants, 14);
  for (const Level level : all_levels) EXPECT_LE(error[level].max, s.bound[level]);
}

INSTANTIATE_TEST_SUITE_P(Library, Strides,
                         testing::Combine(testing::ValuesIn(names()),
                                          testing::Values("global_automatic_klu/stride:16",
                                                          "block_symbolic_inlined/stride:7",
                                                          "group_symbolic_explicit/stride:2")),
                         test_name);

/// An assembly in one go ends elsewhere or nowhere.
TEST(Start, FarFromTheNominalPositionAreContinuedFromIt) {
  struct Start {
    const char *name, *id;
    double time;
  };
  for (const auto& [name, id, time] : {Start{"jansen_leg", "block_automatic_lapack", 0.5},
                                       Start{"jansen_leg", "block_symbolic_explicit", 0.5},
                                       Start{"andrews", "global_automatic_klu", 0.3}}) {
    const Scene scene = library_scene(name);
    const Model m = make_model(scene);
    const auto formulation = make_formulation(find_variant(id), m);
    EXPECT_FALSE(formulation->assemble(time).ok()) << name;
    Discard observer;
    const MonitoredSummary s =
        run_monitored(*formulation, {time, scene.grid.step, 20}, {}, observer);
    EXPECT_EQ(s.outcome(), Outcome::converged) << name << ", " << id;
    EXPECT_EQ(s.instants, 20) << name << ", " << id;
  }
}

}  // namespace
}  // namespace desmo::library_test
