// What is called a defect, and what is not.
#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include "bench/experiments/extremes/verification.h"
#include "cases/extremes/rows.h"

namespace desmo::extremes::judgement_test {
namespace {

/// A case of three instants, and an attempt that has the same error at every level of each.
class Judging : public testing::Test {
 protected:
  Judging() { c.scene.tolerance = 1e-10; }

  void attempted(double error) {
    problem = make_problem(c);
    attempt.steps.assign(3, {Attempt::Flag::none, 2});
    attempt.iterations = 6;
    attempt.errors.assign(1, {});
    for (int i = 0; i < 3; ++i) attempt.errors[0].push_back(PerLevel<double>{error, error, error});
    attempt.stated.assign(3, Attempt::Stated{1, {}});
  }
  void flag(int instant) {
    attempt.steps[instant].flag = Attempt::Flag::failed;
    attempt.errors[0][instant].reset();
    attempt.message = "no convergence";
  }
  /// As a run says of an instant that it is no better than that, at all levels.
  void degrade(int instant, double bound) {
    attempt.steps[instant].flag = Attempt::Flag::degraded;
    attempt.stated[instant]->bound = {bound, bound, bound};
  }
  Verdict verdict() const { return judge(problem, attempt, {}).verdict; }
  std::string reason() const { return judge(problem, attempt, {}).reason; }

  ExtremeCase c = case_of("", usual_chain(1, std::numbers::pi / 3), 1, {0, 0.1, 3});
  Problem problem;
  Attempt attempt;
};

TEST_F(Judging, AnErrorWithinTheBoundIsAsExpected) {
  attempted(5e-10);
  const Judgement j = judge(problem, attempt, {});
  EXPECT_EQ(j.verdict, Verdict::as_expected);
  EXPECT_EQ(j.outcome, Outcome::converged);
  EXPECT_EQ(j.iterations, 6);
  ASSERT_TRUE(j.worst);
  EXPECT_EQ(j.worst->velocity.error, 5e-10);
  EXPECT_EQ(j.worst->velocity.allowed, 1e-9);
}

TEST_F(Judging, AWrongNumberWithoutAFlagIsADefect) {
  attempted(5e-10);
  attempt.errors[0][1]->acceleration = 2e-9;
  EXPECT_EQ(verdict(), Verdict::defect);
  EXPECT_EQ(reason(), "acceleration wrong by 2.0e-09 at t = 0.1 s, allowed 1.0e-09");
}

TEST_F(Judging, LessExactThanExpectedButWithinTheToleranceIsMissed) {
  c.bound = Bound::floor;
  attempted(5e-10);
  EXPECT_EQ(verdict(), Verdict::missed);
  EXPECT_TRUE(reason().starts_with("position wrong by 5.0e-10 at t = 0 s, allowed")) << reason();
  attempted(2e-9);
  EXPECT_EQ(verdict(), Verdict::defect);
}

TEST_F(Judging, ANeedlessFlagIsMissedUnlessItIsAsGoodAsAnAnswer) {
  attempted(0);
  flag(2);
  EXPECT_EQ(verdict(), Verdict::missed);
  EXPECT_EQ(reason(), "no convergence");
  c.may_fail = true;
  EXPECT_EQ(verdict(), Verdict::as_expected);
  attempt.errors[0][0]->position = 1;  // and what it did give was wrong
  EXPECT_EQ(verdict(), Verdict::defect);
}

TEST_F(Judging, AWrongNumberWithABoundIsNoDefect) {
  attempted(5e-10);
  attempt.errors[0][1]->acceleration = 2e-9;
  degrade(1, 3e-9);
  EXPECT_EQ(verdict(), Verdict::missed);  // conditioning allows better
  attempt.errors[0][1]->acceleration = 4e-9;
  EXPECT_EQ(verdict(), Verdict::defect);
  c.may_fail = true;
  attempt.steps[1].flag = Attempt::Flag::doubtful;
  EXPECT_EQ(verdict(), Verdict::as_expected);
}

TEST_F(Judging, DegradedIsExcusedByConditioningAlone) {
  attempted(0);
  attempt.message = "degraded";
  degrade(1, 1e-14);
  EXPECT_EQ(verdict(), Verdict::as_expected);
  EXPECT_EQ(judge(problem, attempt, {}).outcome, Outcome::degraded);
  degrade(1, 1e-9);
  EXPECT_EQ(reason(), "degraded");
}

TEST_F(Judging, EstimatesAreJudgedThemselves) {
  c.bound = Bound::estimates;
  c.factor = 1000;
  attempted(1e-12);
  for (auto& stated : attempt.stated) stated->bound = {2e-12, 2e-12, 2e-12};
  attempt.most = {problem.answers[0].condition, {2e-12, 2e-12, 2e-12}};
  EXPECT_EQ(verdict(), Verdict::as_expected) << reason();
  attempt.stated[2]->bound.velocity = 1e-13;
  EXPECT_EQ(verdict(), Verdict::defect);
  attempt.stated[2]->bound.velocity = 2e-12;
  attempt.most.bound.position = 1e-6;
  EXPECT_TRUE(reason().starts_with("position said to be wrong by up to 1.0e-06")) << reason();
  attempt.most.condition *= 20;
  EXPECT_TRUE(reason().starts_with("condition")) << reason();
}

TEST_F(Judging, NumbersWhereThereIsNoAnswerAreADefect) {
  c.ends_singular = true;
  attempted(0);
  attempt.errors[0][2].reset();
  EXPECT_EQ(verdict(), Verdict::defect);
  EXPECT_EQ(reason(), "plain numbers at t = 0.2 s, where there is no answer");
  flag(2);
  EXPECT_EQ(verdict(), Verdict::as_expected);
}

TEST_F(Judging, WhatIsToBeRefusedMayFailAtOnce) {
  c.is_refused = true;
  attempted(0);
  EXPECT_EQ(verdict(), Verdict::defect);
  attempt.steps.assign(1, {Attempt::Flag::failed});
  EXPECT_EQ(verdict(), Verdict::as_expected);
  attempt.ending = Attempt::Ending::refused;
  EXPECT_EQ(verdict(), Verdict::as_expected);
  c.is_refused = false;
  EXPECT_EQ(verdict(), Verdict::missed);
}

TEST_F(Judging, WhatHasToBeReportedIs) {
  c.failing_body = "dyad1/rocker";
  c.may_fail = true;
  attempted(0);
  flag(2);
  EXPECT_EQ(reason(), "it does not name the group of dyad1/rocker");
  attempt.failed_group =
      problem.modelled->model.entities[problem.modelled->model.find("dyad1/C")].group;
  EXPECT_EQ(verdict(), Verdict::as_expected);
  c.idle_body = "dyad1/coupler";
  EXPECT_EQ(reason(), "it does not report that dyad1/coupler may spin");
  problem.modelled->idle.push_back({"dyad1/coupler", "itself"});
  EXPECT_EQ(verdict(), Verdict::as_expected);
  attempt.heap_growth = 100'000;
  EXPECT_EQ(reason(), "the heap has grown by 100000 bytes");
}

TEST_F(Judging, EndsOfWhatCannotBeSolvedAreKnownToANanosecond) {
  c.goes_on = true;
  attempted(0);
  problem.ends = {0.05, 0.15};
  EXPECT_EQ(reason(), "it says 0 ends of answers of 2");
  attempt.gaps.push_back({0.05, 0.15 + 9e-10, true, {}, {}});
  EXPECT_EQ(verdict(), Verdict::as_expected) << reason();
  attempt.gaps[0].to += 2e-10;
  EXPECT_EQ(reason(), "it says 0.1500000011 s where the answer ends or begins at 0.15 s");
}

TEST_F(Judging, YardsticksAreOtherAttempts) {
  c.bound = Bound::first_case;
  c.factor = 4;
  attempted(3e-12);
  Attempt first = attempt;
  first.errors[0].assign(3, PerLevel<double>{1e-12, 1e-12, 1e-12});
  EXPECT_EQ(judge(problem, attempt, {&first, nullptr}).verdict, Verdict::as_expected);
  first.steps[1].iterations = 4;
  EXPECT_EQ(judge(problem, attempt, {&first, nullptr}).reason,
            "2 iterations where the first case has 4");
  first.errors[0].assign(3, PerLevel<double>{});
  EXPECT_EQ(judge(problem, attempt, {&first, nullptr}).verdict, Verdict::missed);
  attempted(2e-9);
  EXPECT_EQ(judge(problem, attempt, {&first, nullptr}).verdict, Verdict::defect);
}

}  // namespace
}  // namespace desmo::extremes::judgement_test
