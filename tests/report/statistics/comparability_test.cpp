// Conditions under which records may be compared.
#include "report/statistics/comparability.h"

#include "tests/report/points_sample.h"
#include "tests/report/size_sample.h"

namespace desmo::report::comparability_test {
namespace {

std::vector<std::string> reasons(const Json& a, const Json& b) {
  std::vector<std::string> names;
  for (const Difference& d : incomparable_reasons(record_from(a), record_from(b)))
    names.push_back(d.what);
  return names;
}

using Names = std::vector<std::string>;

TEST(Comparability, TwoRunsOfOneMachineAndBuildAreComparable) {
  Json other = origins_record();
  other["record"]["date"] = "2030-01-01T00:00:00Z";
  other["record"]["commit"] = "another";
  other["record"]["build"]["binary"] = std::string(64, 'b');
  other["record"]["machine"]["load_before"] = {5, 5, 5};
  other["paper"]["candidates"][0]["time"]["seconds"][0] = 1;
  EXPECT_EQ(reasons(origins_record(), other), Names{});
}

TEST(Comparability, NamesEveryPartOfTheKeyThatDiffers) {
  const std::vector<std::tuple<const char*, Json, std::string>> changes{
      {"/record/build/compiler", "Clang 20.1.0", "compiler"},
      {"/record/build/type", "Debug", "build type"},
      {"/record/build/flags", "-O2", "flags"},
      {"/record/build/link/type", "static", "linking"},
      {"/record/build/link/flags", "-flto", "linking"},
      {"/record/blas/core", "Haswell", "BLAS core"},
      {"/record/blas/threads", 2, "BLAS threads"},
      {"/record/settings/tolerance", 1e-6, "tolerance"},
      {"/record/settings/max_iterations", 5, "iterations at most"},
      {"/record/settings/guess", "none", "first guess"},
  };
  for (const auto& [place, value, name] : changes) {
    const Json other = changed(origins_record(), place, value);
    EXPECT_EQ(reasons(origins_record(), other), Names{name});
    EXPECT_EQ(reasons(other, origins_record()), Names{name});
  }
  Json other = origins_record();
  set_motion(other, 2, 0.02);
  EXPECT_EQ(reasons(origins_record(), other), Names{"step"});
  set_motion(other, 3);
  EXPECT_EQ(reasons(origins_record(), other), Names{"duration"});
}

TEST(Comparability, AnotherMachineModelOrResultIsNamedOnce) {
  const Json record = origins_record(), candidate = record["paper"]["candidates"][0];
  const std::string place = candidate["case"].get<std::string>() + "/" +
                            std::to_string(candidate["coordinates"].get<int>());
  const auto reasons_with_other = [&](const Json& value, const std::string& other) {
    return reasons(record, Json::parse(replaced_everywhere(record.dump(), value, other)));
  };
  const std::string other(64, 'f');
  EXPECT_EQ(reasons_with_other(record["record"]["machine"]["cpu"], "Other CPU"),
            Names{"CPU model"});
  EXPECT_EQ(reasons_with_other(candidate["model"], other), Names{"model of " + place});
  EXPECT_EQ(reasons_with_other(candidate["results"], other), Names{"results of " + place});
}

TEST(Comparability, WhatOnlyOneRecordsIsNotTheSame) {
  Json other = origins_record();
  const std::string results = other["paper"]["candidates"][0]["results"];
  other["paper"]["candidates"][0].erase("results");
  const auto found = incomparable_reasons(record_from(origins_record()), record_from(other));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].what.starts_with("results of ")) << found[0].what;
  EXPECT_EQ(found[0].first, results);
  EXPECT_EQ(found[0].second, "not recorded");
}

/// Peers find other coordinates: no digest is no difference.
TEST(Comparability, APeerWithoutDigestIsNoDifference) {
  Json json = origins_record(), peer = json["paper"]["candidates"][0];
  peer.erase("results");
  peer.update({{"peer", "tree"},
               {"library", "none"},
               {"library_version", "1"},
               {"method", "by hand"},
               {"guess", "previous"}});
  json["paper"]["peers"] = {peer};
  EXPECT_EQ(reasons(json, json), Names{});
}

TEST(Comparability, WithoutACandidateInCommonThereIsNothingToCompare) {
  Json other = origins_record();
  for (Json& candidate : other["paper"]["candidates"])
    candidate["id"] = "other_" + candidate["id"].get<std::string>();
  for (Json& request : other["paper"]["requests"]) request["request"] = "other";
  EXPECT_EQ(reasons(origins_record(), other), Names{"measurements in common"});
}

/// Steps compare with another machine's by the same sample as everywhere.
TEST(TimedGroups, TakeTheLeastSampleOfAStep) {
  std::size_t steps = 0;
  for (const Json& json : {sizes_record(), modelling_record(), points_record()}) {
    const Record record = record_from(json);
    for (const TimedGroup& group : timed_groups(record))
      for (const auto& [key, step] : group.measurements) {
        if (step->status != Status::ok) continue;
        ++steps;
        const SampleSummary time = *measured(*step).seconds;
        EXPECT_EQ(time.value, std::ranges::min(step->time.seconds)) << name_of(key);
        EXPECT_NEAR(time.without_best.value_or(0), 1.02 * time.value,
                    1e-12 * time.value);  // step_time()
      }
  }
  EXPECT_GT(steps, 60u);
}

}  // namespace
}  // namespace desmo::report::comparability_test
