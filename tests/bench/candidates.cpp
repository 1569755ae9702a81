// Candidates of desmo_bench: timing windows, verification before timing, structure, threads.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "bench/experiments/paper/case_candidate.h"
#include "bench/experiments/paper/options.h"
#include "bench/experiments/paper/request.h"
#include "bench/kit/problem.h"
#include "bench/kit/record/record.h"
#include "bench/kit/time/clock.h"
#include "bench/kit/time/timing_windows.h"
#include "bench/kit/verification.h"
#include "cases/generators/cases.h"
#include "formulations/id.h"
#include "formulations/modelling/modelling.h"
#include "formulations/motion/time_stepping.h"
#include "formulations/variants.h"

namespace desmo::paper::candidates_test {
namespace {

using namespace bench;

void spend(double seconds) {
  for (const double start = cpu_now(); cpu_now() - start < seconds;) {
  }
}

TEST(TimingWindows, KeepTheLeastTimeOfEach) {
  TimingWindows windows(500);  // 25 of 20 instants
  for (const int disturbed : {70, 310, -1}) {
    windows.begin();
    spend(1e-3);  // assembly
    for (int i = 0; i < 500; ++i) {
      spend(2e-6);
      if (i == disturbed) spend(0.05);
      windows.count_instant(i < 20 ? 7 : 1);
    }
  }
  ASSERT_EQ(windows.count(), 25u);
  ASSERT_EQ(windows.samples().size(), 3u);
  for (const std::vector<double>& sample : windows.samples()) EXPECT_EQ(sample.size(), 25u);
  EXPECT_EQ(windows.updates()[0], 140);
  EXPECT_EQ(windows.updates()[24], 20);
  ASSERT_EQ(windows.least().size(), 25u);
  EXPECT_GE(windows.least()[0], 1e-3);
  for (const double seconds : windows.least()) {
    EXPECT_GE(seconds, 4e-5);
    EXPECT_LT(seconds, 0.05);
  }
}

TEST(TimingWindows, AreFewerWhenThereAreFewInstants) {
  for (const auto& [instants, count] :
       {std::pair{1, 1}, {3, 2}, {201, 10}, {499, 24}, {3001, 25}}) {
    TimingWindows windows(instants);
    windows.begin();
    for (int i = 0; i < instants; ++i) windows.count_instant();
    ASSERT_EQ(windows.least().size(), static_cast<std::size_t>(count));
    for (const double seconds : windows.least()) EXPECT_LT(seconds, 1) << instants;
  }
}

TEST(TimingWindows, OfSeveralThreadsCountNoWork) {
  TimingWindows windows(500, Clock::wall);
  windows.begin();
  for (int i = 0; i < 500; ++i) {
    if (i == 30) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    windows.count_instant(7);
  }
  EXPECT_EQ(std::ranges::count(windows.updates(), 0), 25);
  EXPECT_GE(windows.least()[1], 2e-3);  // sleeping takes no CPU time
}

TEST(Candidates, HaveWindowsThatAreAllOfTheirTime) {
  Options o;
  o.duration = 2;
  CaseCandidate candidate(measured_case(find_case("truck_suspension"), 114, o),
                          {parse_id("group_symbolic_klu")}, o);
  EXPECT_EQ(candidate.name(), "truck_suspension/114/group_symbolic_klu");
  EXPECT_FALSE(candidate.time_afresh());
  candidate.add_sample(1);
  EXPECT_FALSE(candidate.is_timed());  // it is not verified yet
  candidate.verify();
  const auto sum = [](const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
  };
  ASSERT_TRUE(candidate.is_verified()) << candidate.message();
  EXPECT_EQ(candidate.verifying_run().errors.instants, 51);
  const TimingWindows& windows = candidate.windows();
  // Between two windows something else may run and leave the caches cold: not always.
  constexpr int max_samples = 50;
  double max_share = 0;
  int taken = 0;
  while (taken++ < max_samples && max_share < 0.95) {
    const double least_before = sum(windows.least());
    const std::optional<double> seconds = candidate.time_afresh();
    ASSERT_TRUE(seconds) << candidate.message();
    const double in_windows = sum(windows.samples().back());
    EXPECT_LE(in_windows, *seconds);
    EXPECT_LE(sum(windows.least()), std::min(least_before, in_windows));
    max_share = std::max(max_share, in_windows / *seconds);
  }
  EXPECT_GE(max_share, 0.95);
  EXPECT_EQ(windows.samples().size(), static_cast<std::size_t>(taken) - 1);
}

TEST(Candidates, ShowWhereTheTimeOfKluAsOneBlockGoes) {
  Options o;
  o.duration = 0.5;
  o.step = 0.1;
  auto candidates = make_case_candidates(o);
  for (const Case& c : cases()) {
    const std::string name = std::string(c.name) + "/558/global_automatic_klu/btf:off";
    const auto found = std::ranges::find(candidates, name, &CaseCandidate::name);
    ASSERT_NE(found, candidates.end()) << name;
    CaseCandidate& candidate = **found;
    EXPECT_EQ(candidate.settings().btf, BlockTriangularForm::off);
    candidate.verify();
    ASSERT_TRUE(candidate.is_verified()) << candidate.message();
    candidate.profile();
    ASSERT_TRUE(candidate.phases()) << name;
    EXPECT_GT(std::ranges::max(*candidate.phases()), 0);
  }
}

TEST(Phases, AreThoseOfTheSettings) {
  const Case& c = find_case("truck_suspension");
  const Model m = make_model(make_scene(c, 114));
  EXPECT_THROW(measure_phases(find_variant("global_automatic_umfpack"),
                              {.btf = BlockTriangularForm::off}, m, {.step = 0.01, .instants = 2}),
               std::invalid_argument);
}

class Idle final : public Part {
  PartResult solve(State&, std::span<const double>, Level) override { return {}; }
};

TEST(Candidates, AreNotTimedWithoutTheGeneratedCodeTheirIdPromises) {
  const Model m = make_model(four_bar(2));
  const Settings settings;
  const auto named = make_formulation(find_variant("group_symbolic_klu"), m);
  EXPECT_EQ(missing_code(*named), "");
  std::vector<DefinedPart> parts;
  for (PartDefinition& d : make_partition(m, Partition::group))
    parts.push_back({std::move(d), std::make_unique<Idle>(), parts.size() != 1});
  const TimeStepping unnamed(m, std::move(parts), settings);
  EXPECT_EQ(missing_code(unnamed),
            "no generated code for 1 of 3 parts, first of group '" + m.groups[1].name + "'");
}

TEST(Problems, CountWhatMoves) {
  EXPECT_EQ(moving_unknowns(make_model(make_scene(find_case("truck_suspension"), 225))), 218);
}

/// Several threads are compared with one, by the same clock; that candidate has a name of its own.
TEST(ParallelCandidates, StandBesideOneThreadByTheWallClock) {
  std::set<std::string> names;
  for (const auto& candidate : make_case_candidates({})) {
    names.insert(candidate->name());
    EXPECT_EQ(candidate->clock() == Clock::wall,
              candidate->threads() > 1 || candidate->name().ends_with("/clock:wall"))
        << candidate->name();
  }
  for (const auto& request : make_request_candidates({})) names.insert(request->name());
  int several = 0;
  for (std::string name : names) {
    const std::size_t at = name.find("/threads:2");
    if (at == name.npos) continue;
    ++several;
    const std::size_t request = std::min(name.find("/request:"), name.size());
    name.insert(request, "/clock:wall");
    EXPECT_TRUE(names.contains(name.erase(at, std::string("/threads:2").size()))) << name;
  }
  EXPECT_GT(several, 0);
}

}  // namespace
}  // namespace desmo::paper::candidates_test
