// What the report says first and last: the answer, the choice of the reference, the limitations.
#include <gtest/gtest.h>

#include <algorithm>

#include "report/tables/tables.h"
#include "tests/report/sample.h"

namespace desmo::report::answer_test {
namespace {

std::string answer_to(const Json& json) { return answer(record_from(json)).paragraphs.front(); }

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

bool limits(const Json& json, const std::string& part) {
  for (const std::string& line : limitations(record_from(json)).paragraphs)
    if (says(line, part)) return true;
  return false;
}

// Every truck cell of an id gets samples around `seconds` at every size of the paper.
void set_times(Json& json, const std::string& id, double seconds) {
  for (const int size : {114, 225, 336, 447, 558})
    set_samples(json, size, id, {seconds * 1.01, seconds, seconds * 0.99});
}

// The dense cells are shared by the families: these references give all of them the same verdicts.
void set_all_families(Json& json, double by_groups) {
  for (const std::string family : {"cholmod", "umfpack", "klu"}) {
    set_times(json, "global_automatic_" + family, 8);
    set_times(json, "group_automatic_" + family, 6 * by_groups);
    set_times(json, "group_symbolic_" + family, 4 * by_groups);
  }
  set_times(json, "group_automatic_lapack", 3 * by_groups);
  set_times(json, "group_symbolic_lapack", 2 * by_groups);
}

TEST(Answer, IsThreeSentences) {
  const std::string text = answer_to(complete_record());
  EXPECT_TRUE(
      text.starts_with("Is a mechanism solved faster one structural group after the other"));
  EXPECT_TRUE(says(text, "TS-TPS_LAP, was 3.5 times as fast"));
  EXPECT_TRUE(says(text, "? "));
  EXPECT_TRUE(says(text, ". Of everything measured on truck_suspension with 558 coordinates, "));
}

TEST(Answer, FollowsTheVerdicts) {
  Json json = complete_record();
  set_all_families(json, 1);
  EXPECT_TRUE(says(answer_to(json),
                   "? Yes, and for the paper's reasons, with every sparse solver "
                   "that can be judged: here that speed-up is 4.00 with cholmod, "
                   "4.00 with umfpack and 4.00 with klu."))
      << answer_to(json);
  set_all_families(json, 8);
  EXPECT_TRUE(says(answer_to(json), "? Not in every point as the paper found"));
  set_times(json, "global_automatic_klu", 100);
  EXPECT_TRUE(says(answer_to(json),
                   "? It depends on the sparse solver in the global reference: "
                   "here that speed-up is 0.50 with cholmod, 0.50 with umfpack "
                   "and 6.25 with klu."))
      << answer_to(json);
  for (const char* family : {"cholmod", "umfpack", "klu"}) erase_family(json, family);
  EXPECT_TRUE(says(answer_to(json), "? This record cannot say: "));
}

TEST(Answer, NamesTheFastestOfAll) {
  Json json = complete_record();
  set_samples(json, 558, "global_automatic_cholmod", {6e-4, 6e-4, 6e-4});  // faster than all others
  set_samples(json, 558, "group_symbolic_lapack", {2e-4, 2e-4, 3e-4});
  EXPECT_TRUE(says(answer_to(json),
                   "group_symbolic_lapack is the fastest, 3.00 [2.00, 3.00] (inconclusive) times "
                   "as fast as the fastest global formulation, "
                   "global_automatic_cholmod."))
      << answer_to(json);
  set_samples(json, 558, "group_symbolic_klu", {2.5e-4, 2.5e-4, 2.5e-4});  // at least
  EXPECT_TRUE(says(answer_to(json),
                   "group_symbolic_klu is the fastest, 2.40 [2.40, 2.40] times as "
                   "fast as the fastest global formulation"))
      << answer_to(json);
  set_samples(json, 558, "global_automatic_klu", {1e-4, 1e-4, 1e-4});
  EXPECT_TRUE(says(answer_to(json), "the global global_automatic_klu is the fastest."));
}

TEST(Answer, CountsWhatFailed) {
  Json json = complete_record();
  EXPECT_FALSE(says(answer_to(json), "failed"));
  fail_cell(json, "truck_suspension", 336, "group_symbolic_lapack");
  EXPECT_TRUE(says(answer_to(json), " 1 formulation failed the verification and has no time"));
}

TEST(References, HoldTheSameFormulationsAgainstEach) {
  Json json = complete_record();
  set_samples(json, 558, "global_automatic_klu", {4, 5, 6});
  set_samples(json, 558, "global_automatic_umfpack", {10, 20, 30});
  set_samples(json, 558, "group_symbolic_lapack", {2, 2, 4});
  const auto table = references(record_from(json), "truck_suspension");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->name, "references_truck_suspension");
  EXPECT_EQ(entry_at(*table, {"global_automatic_klu"}, "CPU s").shown, "5.000 [4.000, 6.000]");
  const Entry klu = entry_at(*table, {"global_automatic_klu"}, "group_symbolic_lapack");
  EXPECT_EQ(klu.shown, "2.50 [1.00, 3.00] inconclusive");
  EXPECT_EQ(klu.digits, (std::vector<std::string>{"2.50", "1.00", "3.00"}));
  EXPECT_EQ(entry_at(*table, {"global_automatic_umfpack"}, "group_symbolic_lapack").shown,
            "10.00 [2.50, 15.00] inconclusive");
  EXPECT_EQ(entry_at(*table, {"MA27 (the paper)"}, "CPU s").shown, "7.100");
  EXPECT_EQ(entry_at(*table, {"MA27 (the paper)"}, "group_symbolic_lapack").shown, "3.6");
  // Slowest last, the paper below.
  EXPECT_EQ(table->rows[table->rows.size() - 2].front().shown, "global_automatic_umfpack");
}

TEST(References, LeaveOutWhatHasNoTime) {
  Json json = complete_record();
  fail_cell(json, "truck_suspension", 558, "global_automatic_klu");
  fail_cell(json, "truck_suspension", 558, "group_symbolic_lapack");
  const auto table = references(record_from(json), "truck_suspension");
  ASSERT_TRUE(table);
  EXPECT_THROW(entry_at(*table, {"global_automatic_klu"}, "CPU s"), std::runtime_error);
  EXPECT_EQ(entry_at(*table, {"global_automatic_umfpack"}, "group_symbolic_lapack").shown,
            failed_mark);
  EXPECT_FALSE(references(record_from(json), "no_such_case"));
}

TEST(Limitations, FollowFromTheRecord) {
  Json json = complete_record();
  EXPECT_TRUE(limits(json, "MA27"));
  EXPECT_TRUE(limits(json, "governor of this machine is unknown"));
  EXPECT_FALSE(limits(json, "not idle"));
  const auto left_out = std::count_if(json["cells"].begin(), json["cells"].end(),
                                      [](const Json& c) { return c["status"] == "not_run"; });
  EXPECT_TRUE(limits(json, std::to_string(left_out) + " cells were left out on purpose"));
  json["record"]["machine"]["governor"] = "performance";
  json["record"]["machine"]["load_before"] = {3.5, 1.0, 1.0};
  json["record"]["dirty"] = true;
  set_motion(json, 2);
  cell_of(json, "truck_suspension", 447, "group_automatic_lapack")["status"] = "not_run";
  EXPECT_FALSE(limits(json, "governor"));
  EXPECT_TRUE(limits(json, "load was 3.50 on 4 cores"));
  EXPECT_TRUE(limits(json, "changes that its commit does not have"));
  EXPECT_TRUE(limits(json, "these times are not to be compared"));
  EXPECT_TRUE(limits(json, std::to_string(left_out + 1) + " cells were left out on purpose"));
  erase_family(json, "umfpack");
  EXPECT_TRUE(limits(json, "Only 2 of 3 sparse solvers"));
}

}  // namespace
}  // namespace desmo::report::answer_test
