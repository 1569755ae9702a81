// Times of a record: their clocks, samples and timing windows.

#include "report/statistics/statistics.h"
#include "tests/report/sample.h"

namespace desmo::report::time_reader_test {
namespace {

TEST(TimeReader, RefusesAClockThatIsNotTheFormulations) {
  Json json = complete_record();
  const std::string clock = "/paper/candidates/2/time/clock";
  expect_refusals(json, {{clock, "sundial", ": \"sundial\" is none of \"cpu\""},
                         {clock, "wall", " is measured by \"cpu\""}});
  const std::string id = json["paper"]["candidates"][2]["id"];
  for (const char* suffix : {"/threads:2", "/clock:wall"}) {
    json["paper"]["candidates"][2]["id"] = id + suffix;
    json["paper"]["candidates"][2]["time"]["clock"] = "cpu";
    EXPECT_CONTAINS(complaint(json), suffix + std::string(" is measured by \"wall\""));
    json["paper"]["candidates"][2]["time"]["clock"] = "wall";
    const Record record = record_from(json);
    EXPECT_EQ(record.wall_candidates.size(), 1u);
    EXPECT_EQ(record.wall_candidates.begin()->second.time.clock, Clock::wall);
    EXPECT_FALSE(record.candidates.contains(record.wall_candidates.begin()->first));
  }
}

TEST(TimeReader, TakesAsAWholeWhatTheWallClockMeasured) {
  Json json = with_windows(complete_record());
  Json& candidate = json["paper"]["candidates"][3];
  candidate["id"] = candidate["id"].get<std::string>() + "/threads:2";
  candidate["threads"] = 2;
  candidate["time"]["clock"] = "wall";
  candidate["time"].erase("windows");
  const std::vector<double> seconds = candidate["time"]["seconds"];
  const Record record = record_from(json);
  ASSERT_EQ(record.wall_candidates.size(), 1u);
  const Measurement& several = record.wall_candidates.begin()->second;
  EXPECT_EQ(several.time.seconds, seconds);
  ASSERT_EQ(several.time.windows.samples.size(), seconds.size());
  for (std::size_t r = 0; r < seconds.size(); ++r)
    EXPECT_EQ(several.time.windows.samples[r], std::vector{seconds[r]});
  EXPECT_DOUBLE_EQ(undisturbed(several.time.windows), std::ranges::min(seconds));
}

TEST(TimeReader, RefusesWindowsThatAreNotAll) {
  const Json record = with_windows(complete_record());
  const std::string windows = "/paper/candidates/3/time/windows";
  expect_refusals(record, {{windows + "/least", std::vector(24, 1e-6), ": 24 windows of 25"},
                           {windows, Json::object(), ": the key 'least'"},
                           {windows + "/least/7", 0, ": "},
                           {windows + "/least/7", 100, windows + ": together they are longer than"},
                           {"/record/settings/windows", 1, ": must be a whole number from 2"},
                           {windows, removed, "/paper/candidates/3/time: the key 'windows'"}});
}

TEST(TimeReader, RefusesSamplesOfWindowsThatDoNotBelongTogether) {
  const Json record = with_samples_of_windows(complete_record());
  const std::string windows = "/paper/candidates/3/time/windows";
  expect_refusals(record, {{windows + "/samples/0", std::vector(24, 1e-6), ": 24 windows of 25"},
                           {windows + "/updates/-", 1, windows + "/updates: 26 windows of 25"},
                           {windows + "/updates/2", -1, ": "},
                           {windows + "/updates", removed, "the key 'updates' is missing"},
                           {windows + "/samples", Json::array(), ": there is none"}});
}

TEST(TimeReader, RefusesSamplesThatAreNoTimes) {
  std::vector<Refusal> refusals{
      {"/paper/candidates/2/time/seconds", Json::array(), ": at least one sample"}};
  for (const char* sample : {"0", "-0.1", "1e-30", "1e30", "\"0.1\"", "null", "[0.1]"})
    refusals.push_back({"/paper/candidates/2/time/seconds/1", Json::parse(sample), ": "});
  expect_refusals(complete_record(), refusals);
}

}  // namespace
}  // namespace desmo::report::time_reader_test
