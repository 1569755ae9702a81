#include "tests/report/points_sample.h"

namespace desmo::report::points_reader_test {
namespace {

const SeriesKey truck_series{truck, 225, 0.01, 101};

TEST(PointsReader, AnAnswerThatIsNoNumberIsAFailure) {
  Json json = points_record();
  point_of(json, "global_automatic_klu")["error"].erase("position");
  const Point point = record_from(json).points.at({truck_series, "global_automatic_klu"});
  EXPECT_EQ(point.status, Status::failed);
  EXPECT_EQ(point.message, "the positions found are beyond all measure");
  EXPECT_TRUE(point.time.seconds.empty());
}

TEST(PointsReader, NamesThePlaceOfWhatIsWrong) {
  const Json json = points_record();
  const std::string point = "/accuracy/points/1/", floor = "/accuracy/floors/0/";
  std::vector<Refusal> refusals{
      {point + "status", "fine", ": \"fine\" is none of \"ok\", \"failed\""},
      {point + "error/position/max", -1, ": "},
      {point + "time_per_step/seconds", Json::array(), ": at least one sample"},
      {point + "time_per_step/seconds/0", 0, ": "},
      {point + "step_seconds", 0, ": "},
      {point + "instants", 1, ": must be a whole number from 2"},
      {floor + "reference/velocity", -1, ": is negative"},
      {floor + "condition", 0, ": "},
      {"/accuracy/points/-", json["accuracy"]["points"][0],
       "/accuracy/points/24: global_automatic_klu of truck_suspension/225 with 101 instants is "
       "given twice"},
      {"/accuracy/floors/-", json["accuracy"]["floors"][0],
       "/accuracy/floors/4: the floor of truck_suspension/225"},
      {"/accuracy/floors", Json::array(),
       "/accuracy/points/0: \"floors\" has nothing of truck_suspension/225"}};
  for (const std::string id : {"", "/guess:linear", "a_b_c/guess", "a_b_c/guess:", "a_b_c/:linear",
                               "a_b_c/", "a_b_c/guess:linear/guess:linear"})
    refusals.push_back({"/accuracy/points/0/id", id, ": \"" + id + "\" is not a formulation"});
  expect_refusals(json, refusals);
  Json other = json;
  set_motion(other, 1, 0.004);
  EXPECT_CONTAINS(complaint(other), "/accuracy/points: none has the step of the record's settings");
}

TEST(Configuration, TakesSettingsInAnyOrderAndKeepsWhatItDoesNotKnow) {
  const auto c = parse_configuration("a_b_c/lanes:8/tolerance:1e-6/guess:linear");
  ASSERT_TRUE(c);
  EXPECT_EQ(c->formulation, "a_b_c");
  EXPECT_EQ(c->guess, "linear");
  EXPECT_EQ(c->jacobian, "newton");
  EXPECT_EQ(c->tolerance, "1e-6");
  EXPECT_EQ(c->others, std::vector<std::string>{"lanes:8"});
  EXPECT_FALSE(c->has_papers_settings());
  EXPECT_FALSE(parse_configuration("a_b_c/lanes:8")->has_papers_settings());
  EXPECT_TRUE(parse_configuration("a_b_c/iterations:2")->has_papers_settings());
  EXPECT_TRUE(parse_configuration("a_b_c/lanes:8")->solves_every_instant());
  EXPECT_FALSE(parse_configuration("a_b_c/lanes:8/stride:4")->solves_every_instant());
  EXPECT_EQ(parse_configuration("a_b_c/monitored")->others, std::vector<std::string>{"monitored"});
  EXPECT_FALSE(parse_configuration("a_b_c/monitored/monitored"));
}

TEST(Configuration, KnowsThePapersAndWhatIteratesAlike) {
  EXPECT_TRUE(parse_configuration("a_b_c")->is_papers());
  EXPECT_FALSE(parse_configuration("a_b_c/tolerance:1e-6")->is_papers());
  const Configuration like = *parse_configuration("a_b_c/guess:adams8/tolerance:1e-6");
  EXPECT_TRUE(
      parse_configuration("d_e_f/tolerance:1e-6/guess:adams8/monitored")->iterates_like(like));
  for (const char* other : {"/guess:adams8", "/tolerance:1e-6", "/guess:linear/tolerance:1e-6"})
    EXPECT_FALSE(parse_configuration("a_b_c" + std::string(other))->iterates_like(like));
}

}  // namespace
}  // namespace desmo::report::points_reader_test
