// Verdicts on runs of extremes: defects, what is missed, and what is as expected.
#include "bench/experiments/extremes/verification.h"

#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include "cases/extremes/rows.h"

namespace desmo::extremes::verification_test {
namespace {

/// A case of three instants, and a run that has the same error at every level of each.
class CaseVerification : public testing::Test {
 protected:
  CaseVerification() { c.scene.tolerance = 1e-10; }

  void ran(double error) {
    known = make_known_case(c);
    run.steps.assign(3, {CaseRun::Flag::none, 2});
    run.errors.assign(1, {});
    for (int i = 0; i < 3; ++i) run.errors[0].push_back(PerLevel<double>{error, error, error});
    run.stated.assign(3, CaseRun::Stated{1, {}});
  }
  void flag(int instant) {
    run.steps[instant].flag = CaseRun::Flag::failed;
    run.errors[0][instant].reset();
    run.message = "no convergence";
  }
  /// Makes an instant unproven, with a radius of `bound` at all levels.
  void degrade(int instant, double bound) {
    run.steps[instant].flag = CaseRun::Flag::unproven;
    run.stated[instant]->radius = {bound, bound, bound};
  }
  ExtremeVerdict verdict() const { return verify(known, run).verdict; }
  std::string reason() const { return verify(known, run).reason; }

  ExtremeCase c = case_of("", usual_chain(1, std::numbers::pi / 3), 1, {0, 0.1, 3});
  KnownCase known;
  CaseRun run;
};

TEST_F(CaseVerification, AnErrorWithinTheBoundIsAsExpected) {
  ran(5e-10);
  const Verification j = verify(known, run);
  EXPECT_EQ(j.verdict, ExtremeVerdict::as_expected);
  EXPECT_EQ(j.outcome, CaseOutcome::converged);
  ASSERT_TRUE(j.worst);
  EXPECT_EQ(j.worst->velocity.error, 5e-10);
  EXPECT_EQ(j.worst->velocity.allowed, 1e-9);
}

TEST_F(CaseVerification, TheLargestErrorIsTheWorstWhereNoneIsAllowed) {
  c.bound = Bound::estimates;  // and the run states radii of 0
  ran(1e-12);
  run.errors[0][1]->velocity = 1e-9;
  EXPECT_EQ(verify(known, run).worst.value().velocity.error, 1e-9);
  run.stated[2]->radius.velocity = 1e-6;
  EXPECT_EQ(verify(known, run).worst.value().velocity.error, 1e-9);
}

TEST_F(CaseVerification, AWrongNumberWithoutAFlagIsADefect) {
  ran(5e-10);
  run.errors[0][1]->acceleration = 2e-9;
  EXPECT_EQ(verdict(), ExtremeVerdict::defect);
  EXPECT_EQ(reason(), "acceleration wrong by 2.0e-09 at t = 0.1 s, allowed 1.0e-09");
}

TEST_F(CaseVerification, LessExactThanExpectedButWithinTheToleranceIsMissed) {
  c.bound = Bound::floor;
  ran(5e-10);
  EXPECT_EQ(verdict(), ExtremeVerdict::missed);
  EXPECT_TRUE(reason().starts_with("position wrong by 5.0e-10 at t = 0 s, allowed")) << reason();
  ran(2e-9);
  EXPECT_EQ(verdict(), ExtremeVerdict::defect);
}

TEST_F(CaseVerification, ANeedlessFlagIsMissedUnlessItIsAsGoodAsAnAnswer) {
  ran(0);
  flag(2);
  EXPECT_EQ(verdict(), ExtremeVerdict::missed);
  EXPECT_EQ(reason(), "no convergence");
  c.may_fail = true;
  EXPECT_EQ(verdict(), ExtremeVerdict::as_expected);
  run.errors[0][0]->position = 1;  // and what it did give was wrong
  EXPECT_EQ(verdict(), ExtremeVerdict::defect);
}

TEST_F(CaseVerification, AWrongNumberWithABoundIsNoDefect) {
  ran(5e-10);
  run.errors[0][1]->acceleration = 2e-9;
  degrade(1, 3e-9);
  EXPECT_EQ(verdict(), ExtremeVerdict::missed);  // conditioning allows better
  run.errors[0][1]->acceleration = 4e-9;
  EXPECT_EQ(verdict(), ExtremeVerdict::defect);
  c.may_fail = true;
  run.steps[1].flag = CaseRun::Flag::other_branch;
  EXPECT_EQ(verdict(), ExtremeVerdict::as_expected);
}

TEST_F(CaseVerification, DegradedIsExcusedByConditioningAlone) {
  ran(0);
  run.message = "degraded";
  degrade(1, 1e-14);
  EXPECT_EQ(verdict(), ExtremeVerdict::as_expected);
  EXPECT_EQ(verify(known, run).outcome, CaseOutcome::degraded);
  degrade(1, 1e-9);
  EXPECT_EQ(reason(), "degraded");
}

TEST_F(CaseVerification, EstimatesAreJudgedThemselves) {
  c.bound = Bound::estimates;
  c.factor = 1000;
  ran(1e-12);
  for (auto& stated : run.stated) stated->radius = {2e-12, 2e-12, 2e-12};
  run.max = {known.answers[0].condition, {2e-12, 2e-12, 2e-12}};
  EXPECT_EQ(verdict(), ExtremeVerdict::as_expected) << reason();
  run.stated[2]->radius.velocity = 1e-13;
  EXPECT_EQ(verdict(), ExtremeVerdict::defect);
  run.stated[2]->radius.velocity = 2e-12;
  run.max.radius.position = 1e-6;
  EXPECT_TRUE(reason().starts_with("position said to be wrong by up to 1.0e-06")) << reason();
  run.max.condition *= 20;
  EXPECT_TRUE(reason().starts_with("condition")) << reason();
}

TEST_F(CaseVerification, NumbersWhereThereIsNoAnswerAreADefect) {
  c.ends_singular = true;
  ran(0);
  run.errors[0][2].reset();
  EXPECT_EQ(verdict(), ExtremeVerdict::defect);
  EXPECT_EQ(reason(), "plain numbers at t = 0.2 s, where there is no answer");
  flag(2);
  EXPECT_EQ(verdict(), ExtremeVerdict::as_expected);
}

TEST_F(CaseVerification, WhatIsToBeRefusedMayFailAtOnce) {
  c.is_refused = true;
  ran(0);
  EXPECT_EQ(verdict(), ExtremeVerdict::defect);
  run.steps.assign(1, {CaseRun::Flag::failed});
  EXPECT_EQ(verdict(), ExtremeVerdict::as_expected);
  run.unsolved = CaseOutcome::refused;
  EXPECT_EQ(verdict(), ExtremeVerdict::as_expected);
  c.is_refused = false;
  EXPECT_EQ(verdict(), ExtremeVerdict::missed);
}

TEST_F(CaseVerification, WhatHasToBeReportedIs) {
  c.failing_body = "dyad1/rocker";
  c.may_fail = true;
  ran(0);
  flag(2);
  EXPECT_EQ(reason(), "it does not name the group of dyad1/rocker");
  run.failed_group = known.modelled->model.entities[known.modelled->model.find("dyad1/C")].group;
  EXPECT_EQ(verdict(), ExtremeVerdict::as_expected);
  c.idle_body = "dyad1/coupler";
  EXPECT_EQ(reason(), "it does not report that dyad1/coupler may spin");
  known.modelled->idle.push_back({"dyad1/coupler", "itself"});
  EXPECT_EQ(verdict(), ExtremeVerdict::as_expected);
  run.heap_growth = 100'000;
  EXPECT_EQ(reason(), "the heap has grown by 100000 bytes");
}

TEST_F(CaseVerification, EndsOfWhatCannotBeSolvedAreKnownToANanosecond) {
  c.past_failures = true;
  ran(0);
  known.ends = {0.05, 0.15};
  EXPECT_EQ(reason(), "it says 0 ends of answers of 2");
  run.gaps.push_back({0.05, 0.15 + 9e-10, true, {}, {}});
  EXPECT_EQ(verdict(), ExtremeVerdict::as_expected) << reason();
  run.gaps[0].to += 2e-10;
  EXPECT_EQ(reason(), "it says 0.1500000011 s where the answer ends or begins at 0.15 s");
}

TEST_F(CaseVerification, YardsticksAreOtherAttempts) {
  c.bound = Bound::first_case;
  c.factor = 4;
  ran(3e-12);
  CaseRun first = run;
  first.errors[0].assign(3, PerLevel<double>{1e-12, 1e-12, 1e-12});
  EXPECT_EQ(verify(known, run, &first).verdict, ExtremeVerdict::as_expected);
  first.steps[1].iterations = 4;
  EXPECT_EQ(verify(known, run, &first).reason, "2 iterations where the first case has 4");
  first.errors[0].assign(3, PerLevel<double>{});
  EXPECT_EQ(verify(known, run, &first).verdict, ExtremeVerdict::missed);
  ran(2e-9);
  EXPECT_EQ(verify(known, run, &first).verdict, ExtremeVerdict::defect);
}

}  // namespace
}  // namespace desmo::extremes::verification_test
