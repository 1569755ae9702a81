// Whether what the extremes are judged by is right itself.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include "bench/stability/chain_solution.h"
#include "bench/stability/problem.h"
#include "cases/extremes/rows.h"
#include "formulations/accuracy/error.h"
#include "formulations/reference.h"

namespace desmo::extreme {
namespace {

ExtremeCase turning(const DyadChain& chain) { return case_of("turning", chain, 1.5, {0, 0.2, 15}); }

TEST(ChainSolution, AgreesWithTheQuadrupleReference) {
  DyadChain chain = usual_chain(3, std::numbers::pi / 3);
  chain.dyads[1] = closed_dyad(chain.dyads[0].joint, {12.5, 1, 0}, 5.5, 7, 1);
  chain.dyads[2] = closed_dyad(chain.dyads[1].joint, {17, -1, 0}, 9, 6.5, -1);
  const ExtremeCase c = turning(chain);
  const Mechanism m = make_mechanism(c.scene);
  std::vector<double> times;
  for (int i = 0; i < c.scene.grid.instants; ++i) times.push_back(c.scene.grid.time(i));
  const Reference reference = make_reference(m, times);
  ChainSolution solution(chain, m);
  ErrorMeasure errors(m, reference.instants, reference.scales);
  for (const double t : times) {
    ASSERT_TRUE(solution.solve(t));
    const ReferenceInstant found = solution.instant();
    errors.accept({0, t, found.q, found.qd, found.qdd});
  }
  const Error e = errors.error();
  ASSERT_EQ(e.instants, c.scene.grid.instants);
  for (const Level level : levels) EXPECT_LT(e[level].max, 3e-16);  // rounded to double
}

TEST(ChainSolution, HasNoAnswerWhereThereIsNone) {
  DyadChain chain{.crank = 2, .start = 0, .dyads = {}};
  chain.dyads = {closed_dyad(crank_pin(chain), {-6, 0, 0}, 5, 3, 1)};  // stretched over 8
  const ExtremeCase c = turning(chain);
  const Mechanism m = model(c.scene.mechanism, {Polynomial{{0, 1}}}).mechanism;
  ChainSolution solution(chain, m);
  EXPECT_FALSE(solution.solve(0));
  EXPECT_TRUE(solution.solve(0.1));
}

TEST(ChainSolution, KeepsTheDeclaredBranchThroughAnyStep) {
  const DyadChain chain = usual_chain(1, std::numbers::pi / 3);
  const Mechanism m = make_mechanism(turning(chain).scene);
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

TEST(ChainSolution, PredictsWhatItsRoundingCauses) {
  const DyadChain chain = usual_chain(100, std::numbers::pi / 3);
  const Mechanism m = make_mechanism(turning(chain).scene);
  ChainSolution solution(chain, m);
  ASSERT_TRUE(solution.solve(0.5));
  ConditionNumber number(m);
  const double ratio = solution.condition() / number(solution.instant().q);
  EXPECT_GT(ratio, 1e-2);
  EXPECT_LT(ratio, 1e2);
}

TEST(Problem, KnowsWhereAThirdGroupLocksAndReopens) {
  const std::vector<ExtremeCase> cases = lock_up(Extent::brief);
  const Problem p = make_problem(cases.front());
  EXPECT_TRUE(p.no_answer.empty()) << p.no_answer;
  int changes = 0;
  for (std::size_t i = 1; i < p.solvable.size(); ++i) changes += p.solvable[i] != p.solvable[i - 1];
  EXPECT_TRUE(p.solvable.front() && p.solvable.back());
  EXPECT_EQ(changes, 2);
}

TEST(Problem, JudgesChainsOfDifferentSizeEachByItsOwn) {
  DyadChain small = usual_chain(1, 1, 1e-3), large = usual_chain(1, 1);
  small.prefix = "small/";
  const Motion motion = Polynomial{{1, 1}};
  const ExtremeCase c = case_of("both", {small, large}, {motion, motion}, {0, 0.1, 3});
  const Problem p = make_problem(c);
  ASSERT_EQ(p.answers.size(), 2u);
  EXPECT_NEAR(p.answers[0].scales.length.position, 1e-3 * p.answers[1].scales.length.position,
              1e-12);
}

TEST(Extremes, AreNumberedAndTheirCasesHaveNamesOfTheirOwn) {
  int number = 0;
  for (const Extreme& row : extremes()) {
    EXPECT_EQ(row.number, ++number);
    EXPECT_EQ(row.cases == nullptr, !row.not_offered.empty());
    if (!row.cases) continue;
    for (const Extent extent : {Extent::brief, Extent::full}) {
      if (row.number == 1 && extent == Extent::full) continue;  // a million dyads
      std::set<std::string> names;
      for (const ExtremeCase& c : row.cases(extent))
        EXPECT_TRUE(names.insert(c.name).second) << c.name;
      EXPECT_FALSE(names.empty());
    }
  }
  EXPECT_EQ(number, 14);
  EXPECT_THROW(find_extreme(15), std::invalid_argument);
}

}  // namespace
}  // namespace desmo::extreme
