// The verdict on made-up checks: every rule, from either side.

#include <optional>

#include "report/check/check_outcome.h"
#include "tests/report/check/check_sample.h"

namespace desmo::report::check_test {
namespace {

CheckOutcome judged(const Json& json) { return compare_sides(check_from(json)); }

// Times of the watched candidate by the factor that head takes longer, in the first pass and, where
// there is one, the second.
TEST(Check, JudgesTimesByBothPasses) {
  struct Passes {
    double first;
    std::optional<double> second;
    CheckVerdict verdict;
    Finding finding;
    bool is_pending = false;
  };
  using enum CheckVerdict;
  for (const Passes& p :
       {Passes{1, {}, pass, Finding::same},
        Passes{1.10, {}, inconclusive, Finding::unconfirmed, true},
        Passes{1.10, 1.09, regression, Finding::regression},
        Passes{1.10, 1.01, pass, Finding::refuted},
        Passes{1.10, 0.90, inconclusive, Finding::noisy, true},  // faster does not confirm slower
        Passes{0.90, 0.91, pass, Finding::improvement},
        Passes{1.045, {}, pass, Finding::same},  // five percent are no alarm
        Passes{1.055, {}, inconclusive, Finding::unconfirmed, true}}) {
    SCOPED_TRACE(p.first);
    Json check = check_sample();
    slow_down(check, watched, p.first);
    if (p.second) confirm(check, watched, *p.second);
    const CheckOutcome j = judged(check);
    EXPECT_EQ(j.verdict, p.verdict);
    for (const TimeFinding& f : j.time.candidates)
      EXPECT_EQ(f.outcome, f.candidate == watched ? p.finding : Finding::same) << f.candidate;
    std::vector<std::string> expected;
    if (p.is_pending) expected = {std::string("second ") + watched};
    EXPECT_EQ(pending(j), expected);
  }
}

// The median alone does not make an alarm: its interval has to agree.
TEST(Check, AMedianWithoutItsIntervalIsTooNoisy) {
  Json check = check_sample();
  for (Json& candidate : check["head"]["paper"]["candidates"]) {
    if (candidate["id"] != "group_symbolic_klu") continue;
    int round = 0;  // 13 rounds 8 % slower, 12 unchanged
    for (Json& seconds : candidate["time"]["seconds"])
      if (round++ % 2 == 0) seconds = seconds.get<double>() * 1.08;
  }
  const CheckOutcome j = judged(check);
  EXPECT_GT(j.time.candidates[2].first.ratio, 1.05);
  EXPECT_LT(j.time.candidates[2].first.low, 1.02);
  EXPECT_EQ(j.verdict, CheckVerdict::inconclusive);
  EXPECT_EQ(pending(j), (std::vector<std::string>{std::string("first ") + watched}));
}

TEST(Check, AControlThatChangesMakesTimesInconclusive) {
  Json check = check_sample();
  for (Json& seconds : check["control"]["head"]) seconds = seconds.get<double>() * 1.03;
  slow_down(check, watched, 1.10);
  confirm(check, watched, 1.10);
  EXPECT_EQ(judged(check).verdict, CheckVerdict::inconclusive);
  EXPECT_EQ(pending(judged(check)).size(), 3u);
  EXPECT_TRUE(pending(judged(check)).front().starts_with("first "));
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

TEST(Check, SidesOfTwoCompilersAreIncomparable) {
  const CheckOutcome j = judged(changed(check_sample(), "/head/record/build/compiler", "other"));
  EXPECT_EQ(j.verdict, CheckVerdict::incomparable);
  EXPECT_TRUE(j.time.candidates.empty());
  ASSERT_EQ(j.differences.size(), 1u);
  EXPECT_EQ(j.differences[0].what, "compiler");
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
  now["head"]["paper"]["candidates"].erase(0);
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
  for (Json& candidate : now["head"]["paper"]["candidates"]) candidate["machine"] = "other";
  EXPECT_EQ(compare_sides(check_from(now), &baseline).verdict, CheckVerdict::pass);
  now["work"]["instructions"][watched]["head"] = 1'020'000;
  const CheckOutcome j = compare_sides(check_from(now), &baseline);
  EXPECT_EQ(j.verdict, CheckVerdict::regression);
  EXPECT_TRUE(j.time.candidates.empty());
  now["work"]["tool"] = "valgrind-9";
  EXPECT_EQ(compare_sides(check_from(now), &baseline).verdict, CheckVerdict::incomparable);
}

TEST(CheckReader, RefusesWhatIsNotAWholeCheck) {
  const std::string name = replaced_everywhere(watched, "/", "~1"),
                    counts = "/work/instructions/" + name + "/head",
                    base = "/base/paper/candidates", head = "/head/paper/candidates";
  Json check = check_sample();
  confirm(check, watched, 1);
  Json left_out = check, untimed = check;
  leave_out(left_out, "head", watched);
  take_no_times(untimed);
  const auto without = [&](const std::string& place) { return changed(check, place, removed); };
  for (const auto& [message, spoilt] : std::vector<std::pair<std::string, Json>>{
           {"another number of rounds", without(head + "/0/time/seconds/0")},
           {"differ in their number of rounds", without("/second/" + name + "/base/0")},
           {"/second: the control is missing", without("/second/control")},
           {"the key 'base' is missing", changed(without("/base"), "/control/base", removed)},
           {"/base: the candidate", without(base + "/0")},
           {"/head: the candidate", without(head + "/0")},
           {"the key 'control' is missing", without("/control")},
           {"/head: nothing was measured",
            changed(changed(check, base, Json::array()), head, Json::array())},
           {"/work/instructions: the candidate truck",
            changed(check, "/work/instructions", Json::object())},
           {"a whole number", changed(check, counts, 0.5)},
           {"a whole number", changed(check, counts, 1e19)},
           {"/control/head/0", changed(check, "/control/head/0", -1)},
           {"desmo-check", changed(check, "/schema", "desmo-results")},
           {"was not run: unknown", left_out},
           {"nothing was measured: neither", changed(untimed, "/work", removed)},
           {"has no times", changed(untimed, "/control", check["control"])}})
    EXPECT_CONTAINS(refusal<InputError>([&] { check_from(spoilt); }), message);
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
