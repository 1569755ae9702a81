// The verdict on made-up checks: every rule, from either side.

#include <functional>

#include "report/check/check_outcome.h"
#include "tests/report/check/check_sample.h"

namespace desmo::report::check_test {
namespace {

CheckOutcome judged(const Json& json) { return compare_sides(check_from(json)); }

Finding outcome_of(const CheckOutcome& j, const std::string& candidate) {
  for (const TimeFinding& f : j.time.candidates)
    if (f.candidate == candidate) return f.outcome;
  ADD_FAILURE() << candidate << " is not judged";
  return Finding::same;
}

std::vector<std::string> pending_lines(const CheckOutcome& j) {
  std::vector<std::string> lines;
  for (const Pending& p : pending(j)) lines.push_back(p.pass + " " + p.candidate);
  return lines;
}

TEST(Check, AnUnchangedTreePasses) {
  const CheckOutcome j = judged(check_sample());
  EXPECT_EQ(j.verdict, CheckVerdict::pass);
  ASSERT_EQ(j.time.candidates.size(), 3u);
  for (const TimeFinding& f : j.time.candidates) {
    EXPECT_EQ(f.outcome, Finding::same) << f.candidate;
    EXPECT_NEAR(f.first.ratio, 1, 0.004) << f.candidate;
    EXPECT_EQ(f.first.rounds, 25u);
  }
  EXPECT_TRUE(pending(j).empty());
}

TEST(Check, ASlowdownIsARegressionOnceConfirmed) {
  Json check = check_sample();
  slow_down(check, watched, 1.10);
  EXPECT_EQ(judged(check).verdict, CheckVerdict::inconclusive);
  EXPECT_EQ(outcome_of(judged(check), watched), Finding::unconfirmed);
  EXPECT_EQ(pending_lines(judged(check)),
            (std::vector<std::string>{std::string("second ") + watched}));
  confirm(check, watched, 1.09);
  const CheckOutcome j = judged(check);
  EXPECT_EQ(j.verdict, CheckVerdict::regression);
  EXPECT_EQ(outcome_of(j, watched), Finding::regression);
  EXPECT_TRUE(pending(j).empty());
  for (const TimeFinding& f : j.time.candidates)
    EXPECT_EQ(f.outcome, f.candidate == watched ? Finding::regression : Finding::same)
        << f.candidate;
}

TEST(Check, ASecondPassThatSaysOtherwiseRefutesTheFirst) {
  Json check = check_sample();
  slow_down(check, watched, 1.10);
  confirm(check, watched, 1.01);
  EXPECT_EQ(judged(check).verdict, CheckVerdict::pass);
  EXPECT_EQ(outcome_of(judged(check), watched), Finding::refuted);
  confirm(check, watched, 0.90);  // faster does not confirm slower
  EXPECT_NE(judged(check).verdict, CheckVerdict::regression);
}

TEST(Check, AGainIsReportedAsOneAndPasses) {
  Json check = check_sample();
  slow_down(check, watched, 0.90);
  confirm(check, watched, 0.91);
  const CheckOutcome j = judged(check);
  EXPECT_EQ(j.verdict, CheckVerdict::pass);
  EXPECT_EQ(outcome_of(j, watched), Finding::improvement);
}

TEST(Check, FivePercentAreNoAlarmAndALittleMoreIs) {
  for (const auto& [factor, expected] :
       {std::pair{1.045, Finding::same}, {1.055, Finding::unconfirmed}}) {
    Json check = check_sample();
    slow_down(check, watched, factor);
    EXPECT_EQ(outcome_of(judged(check), watched), expected) << factor;
  }
}

// The median alone does not make an alarm: its interval has to agree.
TEST(Check, AMedianWithoutItsIntervalIsTooNoisy) {
  Json check = check_sample();
  for (Json& candidate : check["head"]["paper"]["cells"]) {
    if (candidate["id"] != "group_symbolic_klu") continue;
    int round = 0;  // 13 rounds 8 % slower, 12 unchanged
    for (Json& seconds : candidate["time"]["seconds"])
      if (round++ % 2 == 0) seconds = seconds.get<double>() * 1.08;
  }
  const CheckOutcome j = judged(check);
  EXPECT_GT(j.time.candidates[2].first.ratio, 1.05);
  EXPECT_LT(j.time.candidates[2].first.low, 1.02);
  EXPECT_EQ(j.verdict, CheckVerdict::inconclusive);
  EXPECT_EQ(pending_lines(j), (std::vector<std::string>{std::string("first ") + watched}));
}

TEST(Check, AControlThatChangesMakesTimesInconclusive) {
  Json check = check_sample();
  for (Json& seconds : check["control"]["head"]) seconds = seconds.get<double>() * 1.03;
  slow_down(check, watched, 1.10);
  confirm(check, watched, 1.10);
  EXPECT_EQ(judged(check).verdict, CheckVerdict::inconclusive);
  EXPECT_EQ(pending(judged(check)).size(), 3u);
  EXPECT_EQ(pending(judged(check)).front().pass, "first");
}

TEST(Check, InstructionsAlarmFromOnePercentOn) {
  struct Row {
    int head;
    CheckVerdict verdict;
    Finding outcome;
  };
  for (const Row& row : {Row{1'000'000, CheckVerdict::pass, Finding::same},
                         Row{1'009'000, CheckVerdict::pass, Finding::same},
                         Row{1'010'000, CheckVerdict::regression, Finding::regression},
                         Row{990'000, CheckVerdict::pass, Finding::improvement}}) {
    Json check = check_sample();
    check["work"]["instructions"][watched]["head"] = row.head;
    const CheckOutcome j = judged(check);
    EXPECT_EQ(j.verdict, row.verdict) << row.head;
    ASSERT_EQ(j.work.candidates.size(), 3u);
    for (const WorkFinding& f : j.work.candidates)
      EXPECT_EQ(f.outcome, f.candidate == watched ? row.outcome : Finding::same) << row.head;
  }
}

TEST(Check, WrongNumericsShowNoTimeWhateverElseIsThere) {
  Json check = check_sample();
  slow_down(check, watched, 1.10);
  confirm(check, watched, 1.10);
  fail_head(check, "truck_suspension/114/group_symbolic_inlined");
  const CheckRecord record = check_from(check);
  const CheckOutcome j = compare_sides(record);
  EXPECT_EQ(j.verdict, CheckVerdict::invalid);
  for (const TimeFinding& f : j.time.candidates) EXPECT_FALSE(f.candidate.ends_with("inlined"));
  fail_head(check, watched);
  for (const WorkFinding& f : judged(check).work.candidates)
    EXPECT_EQ(f.candidate, "truck_suspension/114/global_automatic_klu");
  const Document document = verdict_document(record, j);
  EXPECT_CONTAINS(document.sections[0].paragraphs[0], "group_symbolic_inlined");
}

// Errors beyond what the record itself allows are wrong answers, whatever it says of them.
TEST(Check, ACellThatExceedsWhatIsAllowedIsWrong) {
  Json check = check_sample();
  check["head"]["paper"]["cells"][0]["verification"]["velocity"] = 1e-3;
  EXPECT_EQ(judged(check).verdict, CheckVerdict::invalid);
}

TEST(Check, OtherMachinesCompilersFlagsBlasAndModelsAreIncomparable) {
  const std::vector<std::pair<std::string, std::function<void(Json&)>>> changes{
      {"CPU model",
       [](Json& side) {
         side["record"]["machine"]["cpu"] = "other";
         for (Json& candidate : side["paper"]["cells"]) candidate["machine"] = "other";
       }},
      {"compiler", [](Json& side) { side["record"]["build"]["compiler"] = "other"; }},
      {"flags", [](Json& side) { side["record"]["build"]["flags"] = "-O0"; }},
      {"BLAS core", [](Json& side) { side["record"]["blas"]["core"] = "other"; }},
      {"model of truck_suspension/114",
       [](Json& side) {
         for (Json& candidate : side["paper"]["cells"]) candidate["model"] = std::string(64, 'a');
       }},
  };
  for (const auto& [what, change] : changes) {
    Json check = check_sample();
    change(check["head"]);
    const CheckOutcome j = judged(check);
    EXPECT_EQ(j.verdict, CheckVerdict::incomparable) << what;
    EXPECT_TRUE(j.time.candidates.empty()) << what;
    ASSERT_FALSE(j.differences.empty()) << what;
    EXPECT_EQ(j.differences[0].what, what);
  }
}

TEST(Check, NewCellsAreSaidAndNotJudged) {
  const std::string candidate = "truck_suspension/114/group_symbolic_inlined";
  Json check = check_sample();
  leave_out(check, "base", candidate);
  check["work"]["instructions"].erase(candidate);
  const CheckOutcome j = judged(check);
  EXPECT_EQ(j.verdict, CheckVerdict::pass);
  EXPECT_EQ(j.time.candidates.size(), 2u);
  ASSERT_EQ(j.excluded.size(), 1u);
  EXPECT_CONTAINS(j.excluded[0].reason, "new");
}

TEST(Check, WorkAloneIsACheck) {
  Json check = check_sample();
  take_no_times(check);
  EXPECT_EQ(judged(check).verdict, CheckVerdict::pass);
  EXPECT_TRUE(judged(check).excluded.empty());
}

// A check that says nothing of a candidate does not pass it.
TEST(Check, ACellOfTheBaselineThatHeadHasNotIsInvalid) {
  const CheckRecord baseline = check_from(one_tree_sample());
  Json now = one_tree_sample();
  now["head"]["paper"]["cells"].erase(0);
  const CheckRecord check = check_from(now);
  const CheckOutcome j = compare_sides(check, &baseline);
  EXPECT_EQ(j.verdict, CheckVerdict::invalid);
  EXPECT_EQ(j.missing.size(), 1u);
  EXPECT_EQ(verdict_document(check, j).sections[0].paragraphs[0],
            "Not measured, but in the baseline: truck_suspension/114/global_automatic_klu.");
}

TEST(Check, InstructionsAreComparedWithABaselineOfAnotherProcessor) {
  const CheckRecord baseline = check_from(one_tree_sample());
  Json now = one_tree_sample();
  now["head"]["record"]["machine"]["cpu"] = "other";
  now["head"]["record"]["blas"]["core"] = "other";
  now["head"]["record"]["libraries"]["lapack"] = "OpenBLAS 0.3.21 for another core";
  for (Json& candidate : now["head"]["paper"]["cells"]) candidate["machine"] = "other";
  EXPECT_EQ(compare_sides(check_from(now), &baseline).verdict, CheckVerdict::pass);
  now["work"]["instructions"][watched]["head"] = 1'020'000;
  const CheckOutcome j = compare_sides(check_from(now), &baseline);
  EXPECT_EQ(j.verdict, CheckVerdict::regression);
  EXPECT_TRUE(j.time.candidates.empty());
  now["work"]["tool"] = "valgrind-9";
  EXPECT_EQ(compare_sides(check_from(now), &baseline).verdict, CheckVerdict::incomparable);
}

TEST(CheckReader, RefusesWhatIsNotAWholeCheck) {
  const auto complaint = [](const auto& spoil) {
    Json check = check_sample();
    confirm(check, watched, 1);
    spoil(check);
    try {
      check_from(check);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_CONTAINS(
      complaint([](Json& c) { c["head"]["paper"]["cells"][0]["time"]["seconds"].erase(0); }),
      "another number of rounds");
  EXPECT_CONTAINS(complaint([](Json& c) { c["second"][watched]["base"].erase(0); }),
                  "number of rounds");
  EXPECT_CONTAINS(complaint([](Json& c) { c["second"].erase("control"); }), "control");
  EXPECT_CONTAINS(complaint([](Json& c) {
                    c.erase("base");
                    c["control"].erase("base");
                  }),
                  "the key 'base' is missing");
  EXPECT_CONTAINS(complaint([](Json& c) { c["base"]["paper"]["cells"].erase(0); }), "base");
  EXPECT_CONTAINS(complaint([](Json& c) { c.erase("control"); }), "control");
  EXPECT_CONTAINS(complaint([](Json& c) { c["head"]["paper"]["cells"].erase(0); }),
                  "head: the candidate");
  EXPECT_CONTAINS(complaint([](Json& c) {
                    for (const char* side : {"base", "head"})
                      c[side]["paper"]["cells"] = Json::array();
                  }),
                  "head");
  EXPECT_CONTAINS(complaint([](Json& c) {
                    c.erase("work");
                    take_no_times(c);
                  }),
                  "nothing was measured");
  EXPECT_CONTAINS(complaint([](Json& c) { leave_out(c, "head", watched); }),
                  "was not run: unknown");
  EXPECT_CONTAINS(complaint([](Json& c) {
                    const Json control = c["control"];
                    take_no_times(c);
                    c["control"] = control;
                  }),
                  "has no times");
  EXPECT_CONTAINS(complaint([](Json& c) { c["work"]["instructions"] = Json::object(); }),
                  "/work/instructions: the candidate truck_suspension");
  EXPECT_CONTAINS(complaint([](Json& c) { c["work"]["instructions"][watched]["head"] = 0.5; }),
                  "whole");
  EXPECT_CONTAINS(complaint([](Json& c) { c["control"]["head"][0] = -1; }), "/control/head/0");
  EXPECT_CONTAINS(complaint([](Json& c) { c["schema"] = "desmo-results"; }), "desmo-check");
}

TEST(CheckReader, KnowsLaterVersionsAndMixedMachinesApart) {
  Json check = check_sample();
  check["schema_version"] = "3.0.0";
  EXPECT_THROW(check_from(check), UnsupportedVersion);
  check["schema_version"] = "2.0.0";
  check["something_new"] = true;
  EXPECT_NO_THROW(check_from(check));
  check["head"]["paper"]["cells"][0]["machine"] = "other";
  EXPECT_THROW(check_from(check), MixedRecord);
}

// Whatever byte is lost or changed, the file is judged or refused, and nothing else happens.
TEST(CheckReader, SpoiltFilesAreRefusedOrJudged) {
  Json check = check_sample();
  confirm(check, watched, 1.1);
  const std::string whole = check.dump();
  for (std::size_t size = 0; size < whole.size(); size += 97)
    EXPECT_THROW(parse_check(whole.substr(0, size)), InputError) << size;
  for (std::size_t i = 0; i < whole.size(); i += 31) {
    std::string spoilt = whole;
    spoilt[i] = static_cast<char>(spoilt[i] ^ (1 << (i % 7)));
    try {
      const CheckRecord record = parse_check(spoilt);
      verdict_document(record, compare_sides(record));
    } catch (const InputError&) {
    }
  }
}

}  // namespace
}  // namespace desmo::report::check_test
