// First and last words of the report: the answer, the choice of the reference, the limitations.

#include "report/formats/formats.h"
#include "report/text/texts.h"
#include "tests/report/sample.h"

namespace desmo::report::answer_test {
namespace {

constexpr const char* finding =
    "The speed-up that the paper found depends on the solver underneath, not on the topology; what "
    "gains is generating the elimination.";

std::vector<std::string> answer_to(const Json& json) {
  return answer(record_from(json)).paragraphs;
}

/// Adds a truck candidate at the largest size like another, with three equal samples.
void add_candidate(Json& json, const std::string& id, double seconds) {
  Json candidate = candidate_of(json, 558, "global_automatic_klu");
  candidate["id"] = id;
  json["paper"]["candidates"].push_back(candidate);
  set_samples(json, 558, id, {seconds, seconds, seconds});
}

/// One reference with the paper's settings and two with others, and generated code with each.
Json record_with_settings() {
  Json json = complete_record();
  for (const char* family : {"cholmod", "umfpack", "klu"}) {
    set_family(json, "global_automatic_" + std::string(family), 8);
    set_samples(json, 558, "global_automatic_" + std::string(family), {8, 8, 8});
  }
  add_candidate(json, "global_automatic_klu/guess:adams8/jacobian:step/tolerance:1e-10", 4);
  add_candidate(json, "global_automatic_klu/guess:hermite5", 5);
  add_candidate(json, "group_symbolic_explicit/guess:adams8/tolerance:1e-10", 0.5);
  add_candidate(json, "group_symbolic_explicit/guess:hermite5", 0.125);
  add_candidate(json, "group_symbolic_explicit/guess:adams8/lanes:4/tolerance:1e-10", 0.25);
  add_candidate(json, "group_symbolic_explicit/guess:adams8/segments:8/tolerance:1e-10", 0.125);
  return json;
}

TEST(Answer, IsThreeFixedSentencesWithNumbers) {
  Json json = record_with_settings();
  set_family(json, "group_symbolic_lapack", 2);
  set_family(json, "global_automatic_klu", 1);
  set_samples(json, 558, "global_automatic_klu", {8, 8, 8});
  const std::vector<std::string> text = answer_to(json);
  ASSERT_EQ(text.size(), 3u);
  EXPECT_CONTAINS(text[0], "TS-TPS_LAP (group after group, generated equations, LAPACK), was 3.5 ");
  EXPECT_CONTAINS(text[0], "by the sparse solver: cholmod 4.0, umfpack 4.0, klu 1.2");
  EXPECT_EQ(text[1], finding);
  EXPECT_EQ(
      text[2],
      "On one thread, a generated elimination of truck_suspension with 558 coordinates is 8.0 "
      "times as fast as the fastest global "
      "reference with the same guess and tolerance, 16 times with equal parts side by side "
      "(lanes), 32 times with segments of a known motion side by side; "
      "over the reference with the paper's settings 16, 32 and 64 times.");
}

// Two repetitions may be disturbed alike: no number is quoted.
TEST(Answer, QuotesNoMeanOfFewerThanThreeRepetitions) {
  Json json = record_with_settings();
  set_samples(json, 336, "group_symbolic_lapack", {2, 2});
  const Section section = answer(record_from(json));
  EXPECT_EQ(section.paragraphs,
            (std::vector<std::string>{sentence("answer.first_look"),
                                      "The filed records say: " + std::string(finding)}));
}

TEST(Answer, SaysWhatTheRecordDoesNotShow) {
  Json json = record_with_settings();
  set_family(json, "group_symbolic_lapack", 2);  // 4 times, whichever solver
  EXPECT_EQ(answer_to(json)[1],
            "The filed records say, and this one does not show: " + std::string(finding));
  for (const char* family : {"cholmod", "umfpack", "klu"})
    erase_candidate(json, 336, "global_automatic_" + std::string(family));
  EXPECT_CONTAINS(answer_to(json)[0], "by the sparse solver: not measured.");
}

TEST(Answer, HasNoClauseForWhatWasNotMeasured) {
  Json json = record_with_settings();
  for (const char* id :
       {"group_symbolic_explicit/guess:adams8/lanes:4/tolerance:1e-10", "global_automatic_cholmod",
        "global_automatic_umfpack", "global_automatic_klu"})
    erase_candidate(json, 558, id);
  EXPECT_TRUE(answer_to(json)[2].ends_with(
      "with the same guess and tolerance, 32 times with segments of a known motion side by side."))
      << answer_to(json)[2];
  for (const char* family : {"cholmod", "umfpack", "klu"}) erase_family(json, family);
  EXPECT_EQ(answer_to(json),
            (std::vector<std::string>{
                "No generated elimination of truck_suspension stands next to a global reference "
                "with the same guess and tolerance."}));
}

TEST(Answer, LeavesOutIncompleteMeansAndMarksTheInconclusive) {
  Json json = record_with_settings();
  set_family(json, "group_symbolic_lapack", 2);
  set_family(json, "global_automatic_umfpack", 8, 0.5);
  fail_candidate(json, 336, "global_automatic_cholmod");
  EXPECT_CONTAINS(answer_to(json)[0], "by the sparse solver: umfpack 4.0 (inconclusive), klu 4.0.");
}

TEST(Answer, CountsWhatFailed) {
  Json json = complete_record();
  EXPECT_LACKS(answer_to(json).back(), "Failed");
  fail_candidate(json, 336, "group_symbolic_lapack");
  EXPECT_CONTAINS(answer_to(json).back(), "Failed their verification and have no time: 1;");
}

TEST(Best, ComparesLikeForLike) {
  const Table table = table_of(record_with_settings(), "best");
  EXPECT_EQ(table.rows.size(), 6u);
  expect_row(table, {"global, best settings"},
             {{"like for like", "1.00 reference"}, {"paper's settings", "2.00 …"}});
  expect_row(table, {"the same, in lanes"}, {{"like for like", "16.00 …"}});
  expect_row(table, {"the same, in segments"}, {{"paper's settings", "64.00 …"}});
  // Neither over another guess nor over another tolerance.
  expect_row(table, {"generated elimination, best settings"},
             {{"id", "group_symbolic_explicit/guess:adams8/tolerance:1e-10"},
              {"like for like", "8.00 …"},
              {"paper's settings", "16.00 …"}});
}

// A reference has the paper's algorithm and nothing else, and so has what is held against it,
// though another run be faster: checked, with an option of the linear solver, in another scalar.
TEST(Best, IsOfThePapersAlgorithmHoweverFastAnotherRunIs) {
  const Json json = record_with_settings();
  const Document plain = make_report(record_from(json));
  for (const std::string other :
       {"/check:proof", "/btf:off", "/scalar:float", "/factorisation:per_level",
        "/lanes:4/stride:2", "/not yet known", "/later:1"}) {
    SCOPED_TRACE(other);
    Json more = json;
    for (const char* id : {"global_automatic_klu", "group_symbolic_explicit",
                           "global_automatic_klu/guess:adams8/jacobian:step/tolerance:1e-10",
                           "group_symbolic_explicit/guess:adams8/tolerance:1e-10"})
      add_candidate(more, id + other, 0.01);
    const Document document = make_report(record_from(more));
    EXPECT_EQ(to_csv(table_named(document, "best")), to_csv(table_named(plain, "best")));
    const std::string every = "formulations_truck_suspension_558";
    const std::vector<std::string> row{"group_symbolic_explicit/guess:hermite5"};
    for (const char* column : {"speed-up", "like for like"})
      EXPECT_EQ(entry_at(table_named(document, every), row, column).shown,
                entry_at(table_named(plain, every), row, column).shown);
  }
}

// A library that is faster is no generated elimination.
TEST(Best, CallsGeneratedWhatIsGenerated) {
  Json json = record_with_settings();
  const std::string plain = to_csv(table_of(json, "best"));
  set_family(json, "group_symbolic_lapack", 1e-3);
  add_candidate(json, "group_symbolic_lapack/guess:adams8/tolerance:1e-10", 1e-3);
  EXPECT_EQ(to_csv(table_of(json, "best")), plain);
}

bool limits(const Json& json, const std::string& part) {
  return says(limitations(record_from(json)).paragraphs, part);
}

TEST(Limitations, AreEightAtMostAndHoldOfTheRecord) {
  Json json = complete_record();
  EXPECT_TRUE(limits(json, "MA27"));
  EXPECT_TRUE(limits(json, "governor is unknown"));
  EXPECT_FALSE(limits(json, "changes that its commit does not have"));
  json["record"]["dirty"] = true;
  set_motion(json, 2);
  EXPECT_TRUE(limits(json, "changes that its commit does not have"));
  EXPECT_TRUE(limits(json, "these times are not to be compared"));
  EXPECT_LE(limitations(record_from(json)).paragraphs.size(), 8u);
  json["record"]["machine"]["governor"] = "performance";
  json["record"]["machine"]["load_before"] = {0, 0, 0};
  EXPECT_FALSE(limits(json, "governor"));
  json["record"]["machine"]["load_before"] = {3.5, 1.0, 1.0};
  EXPECT_TRUE(limits(json, "not idle"));
}

}  // namespace
}  // namespace desmo::report::answer_test
