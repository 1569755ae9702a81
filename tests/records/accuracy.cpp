// Time against error: what trials measure, and that a choice keeps its promise.

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "bench/experiments/accuracy/search.h"
#include "bench/experiments/accuracy/settings_grid.h"
#include "cases/generators/cases.h"
#include "cases/io/files.h"
#include "formulations/modelling/modelling.h"
#include "tests/started.h"

namespace desmo::accuracy::accuracy_test {
namespace {

constexpr double seconds = 0.4;

using bench::make_problem;

Plan whole(const Scene& scene) { return make_plan(make_model(scene), {}); }

Problem problem(const Scene& scene, double duration, int compared) {
  return make_problem(whole(scene), time_grid(duration, scene.grid.step), compared);
}

TEST(SettingsGrids, AreAllDifferentAndIncludeThePapers) {
  const Variant& in_order = find_variant("group_symbolic_explicit");
  const auto of_all = full_settings(variants().front()), with_lanes = full_settings(in_order);
  for (const auto& all : {minimal_settings(), reduced_settings(), of_all, with_lanes}) {
    std::set<std::string> ids;
    for (const Settings& s : all) ids.insert(id_with(variants().front(), s));
    EXPECT_EQ(ids.size(), all.size());
    EXPECT_TRUE(ids.contains(variants().front().id));
  }
  EXPECT_GT(with_lanes.size(), of_all.size());
}

/// Powers of ten between which the errors below 1 lie that some settings end at.
std::set<int> levels(const Problem& problem, const char* id, const std::vector<Settings>& some) {
  std::set<int> found;
  for (const Settings& s : some) {
    Trial trial(problem, {&find_variant(id), s});
    trial.verify();
    if (trial.is_verified() && trial.error.position.max < 1)
      found.insert(static_cast<int>(std::floor(std::log10(trial.error.position.max))));
  }
  return found;
}

TEST(Trials, ReducedSettingsReachErrorsOfFourSizes) {
  for (const Case& c : cases()) {
    const Problem p = problem(make_scene(c, 114), 1, 21);
    for (const char* id : {"global_automatic_klu", "group_symbolic_inlined", "block_symbolic_klu",
                           "group_symbolic_explicit", "block_symbolic_explicit"})
      EXPECT_GE(levels(p, id, reduced_settings()).size(), 4u) << c.name << ' ' << id;
    EXPECT_GE(levels(p, "global_automatic_klu", minimal_settings()).size(), 4u) << c.name;
  }
}

/// No stride hides its error between the instants that it solves, whatever the grid.
TEST(Trials, SeeTheErrorBetweenSolvedInstants) {
  const Scene scene = make_scene(find_case("truck_suspension"), 114);
  for (const auto& [duration, compared] : {std::pair{1.0, 21}, {2.0, 101}, {0.8, 6}}) {
    const Problem p = problem(scene, duration, compared);
    double last = 1e-12;  // solved, none has more
    for (const int stride : {1, 2, 4, 8, 16}) {
      Trial trial(p, {&find_variant("group_symbolic_inlined"), {.stride = stride}});
      trial.verify();
      ASSERT_TRUE(trial.is_verified()) << trial.message();
      EXPECT_EQ(trial.error.instants, compared);
      if (stride == 1)
        EXPECT_LT(trial.error.position.max, last);
      else
        EXPECT_GT(trial.error.position.max, 4 * last) << stride << " of " << compared;
      last = std::max(last, trial.error.position.max);
    }
  }
}

TEST(Problems, CompareInstantsWhereverTheyStandBetweenSolvedOnes) {
  const Scene scene = library_scene("slider_crank");
  struct Spread {
    int instants, compared;
    std::size_t min_places;  // between two instants solved of 16
  };
  for (const auto& [instants, compared, min_places] :
       {Spread{101, 21, 8}, {101, 50, 16}, {1001, 21, 8}, {2001, 1001, 16}, {3, 2, 2}}) {
    const TimeGrid grid{0, 1e-3, instants};
    const Problem p = make_problem(whole(scene), grid, compared);
    ASSERT_EQ(p.reference.instants.size(), static_cast<std::size_t>(compared));
    EXPECT_EQ(p.reference.instants.front().time, 0);
    EXPECT_EQ(p.reference.instants.back().time, grid.time(instants - 1));
    std::set<int> indices, places;
    for (const ReferenceInstant& i : p.reference.instants) {
      const int index = static_cast<int>(std::lround(i.time / grid.step));
      EXPECT_EQ(i.time, grid.time(index));
      EXPECT_TRUE(indices.empty() || index > *indices.rbegin());
      indices.insert(index);
      places.insert(index % 16);
    }
    EXPECT_GE(places.size(), min_places) << instants;
  }
}

TEST(Trials, HaveNoTimeWithoutAnError) {
  const Problem p = problem(make_scene(find_case("four_bar"), 114), 0.1, 3);
  Trial refused(p, {&find_variant("global_automatic_klu"), {.lanes = 4}});
  refused.verify();
  refused.time(0);
  EXPECT_TRUE(refused.is_not_run());
  EXPECT_FALSE(refused.is_timed());
  EXPECT_FALSE(refused.message().empty());

  Trial failing(p, {&find_variant("global_automatic_klu"), {.max_iterations = 1}});
  failing.verify();
  failing.time(0);
  EXPECT_TRUE(failing.is_failed());
  EXPECT_FALSE(failing.is_timed());
}

/// Returns the error at instants that the search has not looked at.
double error_elsewhere(const Scene& scene, const Configuration& c, Level level) {
  const Problem p = problem(scene, seconds, 47);
  Trial trial(p, c);
  trial.verify();
  EXPECT_TRUE(trial.is_verified()) << trial.message();
  return trial.error[level].max;
}

TunedMotion begin_and_whole(const Scene& scene) {
  return {problem(scene, seconds, 1001), problem(scene, seconds / 4, 11)};
}

class Choice : public testing::TestWithParam<const char*> {};

TEST_P(Choice, KeepsItsPromiseOnTheWholeMotion) {
  const std::string name = GetParam();
  const Scene scene = name.ends_with("114")
                          ? make_scene(find_case(name.substr(0, name.size() - 4)), 114)
                          : library_scene(name);
  const TunedMotion motion = begin_and_whole(scene);
  const SearchOptions options{.formulations = {&find_variant("group_automatic_klu"),
                                               &find_variant("block_symbolic_inlined")},
                              .rounds = 1};
  using enum Level;
  std::vector<std::pair<double, Level>> promises{{1e-3, acceleration}, {1e-11, position}};
  if (name == "slider_crank")  // every error at both levels of one mechanism
    promises.insert(
        promises.end(),
        {{1e-3, position}, {1e-7, position}, {1e-7, acceleration}, {1e-11, acceleration}});
  for (const auto& [allowed, level] : promises) {
    const SearchResult found = search(motion, {level, allowed, 0}, options);
    ASSERT_TRUE(found.choice) << allowed;
    EXPECT_LE(found.error[level].max, allowed / 2);
    EXPECT_LE(error_elsewhere(scene, *found.choice, level), allowed)
        << id_with(*found.choice->variant, found.choice->settings);
  }
}

INSTANTIATE_TEST_SUITE_P(Mechanisms, Choice,
                         testing::Values("truck_suspension_114", "four_bar_114", "slider_crank",
                                         "rssr", "stewart"));

TEST(Search, GivesTheMostAccurateWithinABudget) {
  const TunedMotion motion = begin_and_whole(library_scene("slider_crank"));
  const SearchOptions options{.formulations = {&find_variant("group_automatic_klu")}, .rounds = 1};
  const SearchResult found = search(motion, {Level::position, 0, 1.0}, options);
  ASSERT_TRUE(found.choice);
  EXPECT_LT(found.error.position.max, 1e-13);
  EXPECT_FALSE(search(motion, {Level::position, 0, 1e-12}, options).choice);
}

using AccuracyRecord = InFolder;

// A record of the program is one that the report reads, and has what the filter lets through.
TEST_F(AccuracyRecord, IsReadByTheReport) {
  const std::string record = file("record.json");
  ASSERT_EQ(shell(DESMO_BENCH " accuracy --quick --repetitions 1 --record " + record +
                  " --filter 'four_bar/114/group_symbolic_inlined$'"),
            0);
  const std::string outcome = " | grep -q 'four_bar *0.001 *group_symbolic_inlined'";
  EXPECT_EQ(shell(DESMO_REPORT " tables --all " + record + outcome), 0);
}

}  // namespace
}  // namespace desmo::accuracy::accuracy_test
