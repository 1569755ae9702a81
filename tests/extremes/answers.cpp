// The answers that runs of extremes are compared with are right themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/experiments/extremes/chain_solution.h"
#include "bench/experiments/extremes/known_case.h"
#include "cases/extremes/rows.h"
#include "formulations/model/scales.h"
#include "formulations/verification/condition.h"
#include "formulations/verification/error.h"
#include "formulations/verification/reference/reference.h"
#include "formulations/verification/reference/wide_instant.h"

namespace desmo::extremes::answers_test {
namespace {

ExtremeCase turning(const DyadChain& chain) { return case_of("turning", chain, 1.5, {0, 0.2, 15}); }

/// Position, velocity and acceleration of a point in quadruple precision.
struct Moving {
  Quadruple x, y, vx, vy, ax, ay;
};

Moving moving(const Model& m, const ReferenceInstant& r, const std::string& point) {
  const Entity& e = m.entities[m.find(point)];
  if (e.fixed) return {m.fixed_values[e.first], m.fixed_values[e.first + 1], 0, 0, 0, 0};
  const auto wide = [&](const std::vector<double>& high, const std::vector<double>& rest, int i) {
    return Quadruple(high[e.first + i]) + rest[e.first + i];
  };
  return {wide(r.q, r.remainder.q, 0),     wide(r.q, r.remainder.q, 1),
          wide(r.qd, r.remainder.qd, 0),   wide(r.qd, r.remainder.qd, 1),
          wide(r.qdd, r.remainder.qdd, 0), wide(r.qdd, r.remainder.qdd, 1)};
}

/// The square of the distance of two points is that of the length, and stays so.
void expect_distance(const Moving& a, const Moving& b, double length) {
  const Quadruple x = b.x - a.x, y = b.y - a.y, vx = b.vx - a.vx, vy = b.vy - a.vy;
  const Quadruple ax = b.ax - a.ax, ay = b.ay - a.ay;
  EXPECT_LT(static_cast<double>(abs(x * x + y * y - Quadruple(length) * length)), 1e-28);
  EXPECT_LT(static_cast<double>(abs(x * vx + y * vy)), 1e-27);
  EXPECT_LT(static_cast<double>(abs(x * ax + y * ay + vx * vx + vy * vy)), 1e-26);
}

DyadChain any_chain() {
  DyadChain chain = usual_chain(3, std::numbers::pi / 3);
  chain.dyads[1] = closed_dyad(chain.dyads[0].joint, {12.5, 1, 0}, 5.5, 7, 1);
  chain.dyads[2] = closed_dyad(chain.dyads[1].joint, {17, -1, 0}, 9, 6.5, -1);
  return chain;
}

TEST(ChainSolution, KeepsEveryLengthToQuadruplePrecision) {
  const DyadChain chain = any_chain();
  const ExtremeCase c = turning(chain);
  const Model m = make_model(c.scene);
  ChainSolution solution(chain, m);
  for (int i = 0; i < c.scene.grid.instants; ++i) {
    ASSERT_TRUE(solution.solve(c.scene.grid.time(i)));
    const ReferenceInstant r = solution.instant();
    Moving before = moving(m, r, "crank/B");
    expect_distance(moving(m, r, "crank/A"), before, chain.crank);
    for (std::size_t k = 0; k < chain.dyads.size(); ++k) {
      const std::string dyad = "dyad" + std::to_string(k + 1);
      const Moving joint = moving(m, r, dyad + "/C");
      expect_distance(before, joint, chain.dyads[k].coupler);
      expect_distance(moving(m, r, dyad + "/D"), joint, chain.dyads[k].rocker);
      before = joint;
    }
  }
}

/// The mechanism has the squares of lengths, rounded, so that more digits cannot agree.
TEST(ChainSolution, AgreesWithTheQuadrupleReference) {
  const DyadChain chain = any_chain();
  const ExtremeCase c = turning(chain);
  const Model m = make_model(c.scene);
  std::vector<double> times;
  for (int i = 0; i < c.scene.grid.instants; ++i) times.push_back(c.scene.grid.time(i));
  const Reference reference = make_reference(m, times);
  ChainSolution solution(chain, m);
  ErrorMeasure errors(m, reference.instants, reference.scales);
  for (const double t : times) {
    ASSERT_TRUE(solution.solve(t));
    const ReferenceInstant found = solution.instant();
    errors.observe({0, t, found.q, found.qd, found.qdd});
  }
  const SolutionError e = errors.error();
  ASSERT_EQ(e.instants, c.scene.grid.instants);
  for (const Level level : all_levels) EXPECT_LT(e[level].max, 1e-14);
}

TEST(ChainSolution, HasNoAnswerWhereThereIsNone) {
  const DyadChain chain = extremes::one_dyad(2, 0, -6, 5, 3);  // stretched over 8
  const ExtremeCase c = turning(chain);
  const Model m = model_mechanism(c.scene.mechanism, {Polynomial{{0, 1}}}).model;
  ChainSolution solution(chain, m);
  EXPECT_FALSE(solution.solve(0));
  EXPECT_TRUE(solution.solve(0.1));
}

TEST(ChainSolution, KeepsTheDeclaredBranchThroughAnyStep) {
  const DyadChain chain = usual_chain(1, std::numbers::pi / 3);
  const Model m = make_model(turning(chain).scene);
  ChainSolution above(chain, m), below(chain, m);
  std::vector<double> mirrored = m.estimate;
  const int joint = m.entities[m.find("dyad1/C")].first;
  mirrored[joint + 1] = -mirrored[joint + 1];
  below.declare(mirrored);
  for (const double t : {0.0, 3.0, 1.0}) {
    ASSERT_TRUE(above.solve(t) && below.solve(t));
    EXPECT_GT(above.instant().q[joint + 1], 0);
    EXPECT_LT(below.instant().q[joint + 1], 0);
  }
}

/// Along a short chain; of a long one the equations' own condition number knows no more than that
/// each of them may be wrong by as much as the whole mechanism is large.
TEST(ChainSolution, TellsItsConditionAsTheEquationsDo) {
  const DyadChain chain = usual_chain(1, std::numbers::pi / 3);
  const Model m = make_model(turning(chain).scene);
  ChainSolution solution(chain, m);
  ConditionNumber number(m);
  for (const double t : {0.0, 0.5, 2.0}) {
    ASSERT_TRUE(solution.solve(t));
    const double ratio = solution.condition() / number(solution.instant().q);
    EXPECT_GT(ratio, 0.05);
    EXPECT_LT(ratio, 2);
  }
}

TEST(ChainSolution, PredictsHowRoundedLengthsMoveTheLastJoint) {
  const DyadChain chain = usual_chain(100, std::numbers::pi / 3);
  DyadChain rounded = chain;
  constexpr double relative = 1e-10;
  for (std::size_t k = 0; k < rounded.dyads.size(); ++k)
    rounded.dyads[k].coupler *= 1 + (k % 3 ? relative : -relative);
  const Model m = make_model(turning(chain).scene);
  ChainSolution right(chain, m), moved(rounded, m);
  ASSERT_TRUE(right.solve(0.5) && moved.solve(0.5));
  const ReferenceInstant a = right.instant(), b = moved.instant();
  double largest = 0;
  for (int i = 0; i < m.coordinates(); ++i) largest = std::max(largest, std::abs(a.q[i] - b.q[i]));
  const double predicted = relative * right.condition() * nominal_size(m);
  EXPECT_LT(largest, predicted);
  EXPECT_GT(largest, predicted / 1000);
}

TEST(KnownCase, KnowsWhereAThirdGroupLocksAndReopens) {
  const std::vector<ExtremeCase> cases = lock_up(Extent::brief);
  const KnownCase p = make_known_case(cases.front());
  EXPECT_TRUE(p.no_answer.empty()) << p.no_answer;
  int changes = 0;
  for (std::size_t i = 1; i < p.solvable.size(); ++i) changes += p.solvable[i] != p.solvable[i - 1];
  EXPECT_TRUE(p.solvable.front() && p.solvable.back());
  EXPECT_EQ(changes, 2);
  ASSERT_EQ(p.ends.size(), 2u);
  const DyadChain& chain = cases.front().chains.front();
  ChainSolution solution(chain, p.modelled->model);
  for (const double end : p.ends) {
    EXPECT_NE(solution.solve(end - 1e-12), solution.solve(end + 1e-12)) << end;
    EXPECT_EQ(solution.solve(end - 1e-12), end == p.ends[0]);
  }
}

TEST(KnownCase, JudgesChainsOfDifferentSizeEachByItsOwn) {
  DyadChain small = usual_chain(1, 1, 1e-3), large = usual_chain(1, 1);
  small.prefix = "small/";
  const Motion motion = Polynomial{{1, 1}};
  const ExtremeCase c = case_of("both", {small, large}, {motion, motion}, {0, 0.1, 3});
  const KnownCase p = make_known_case(c);
  ASSERT_EQ(p.answers.size(), 2u);
  EXPECT_NEAR(p.answers[0].scales.length.position, 1e-3 * p.answers[1].scales.length.position,
              1e-12);
}

TEST(Extremes, AreNumberedAndTheirCasesHaveNamesOfTheirOwn) {
  int number = 0;
  for (const Extreme& row : all_extremes()) {
    EXPECT_EQ(row.number, ++number);
    for (const Extent extent : {Extent::brief, Extent::full}) {
      if (row.number == 1 && extent == Extent::full) continue;  // a million dyads
      std::set<std::string> names;
      for (const ExtremeCase& c : row.cases(extent))
        EXPECT_TRUE(names.insert(c.name).second) << c.name;
      EXPECT_FALSE(names.empty());
    }
  }
  EXPECT_EQ(number, 15);
  EXPECT_THROW(find_extreme(16), std::invalid_argument);
}

}  // namespace
}  // namespace desmo::extremes::answers_test
