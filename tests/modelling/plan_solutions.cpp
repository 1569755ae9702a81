// Plans deliver the same as the whole solution, and no part goes further than asked.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "formulations/model/partition.h"
#include "formulations/motion/internals.h"
#include "tests/describing.h"
#include "tests/every_variant.h"
#include "tests/modelling/plan.h"

namespace desmo::plan_solutions_test {
namespace {

using enum Level;

const std::vector<double>& times() {
  static const std::vector<double> all = instants(0.4);
  return all;
}

EVERY_VARIANT(EveryPlan);

TEST_P(EveryPlan, DeliversWhatTheWholeSolutionDoes) {
  static const Solved whole(two_axles(), times(), "group_automatic_eigen");
  for (const std::vector<Named>& asked : requests()) {
    const std::vector<Named> all = asked.empty() ? all_of("") : asked;
    const Plan plan = plan_of(asked);
    ASSERT_EQ(plan.outputs.size(), all.size());
    const auto f = make_formulation(GetParam(), plan.model, Settings{1e-13, 25});
    f->solve_only(plan.levels);
    for (int k = 0; k < whole.instants() && !HasFailure(); ++k) {
      const Summary s = f->step(times()[k], plan.level());
      ASSERT_TRUE(s.ok()) << all.front().entity << ": " << describe(s, plan.model);
      for (std::size_t o = 0; o < all.size(); ++o) {
        const auto& [name, level] = all[o];
        const Entity& e = plan.model.entities[plan.outputs[o].entity];
        ASSERT_EQ(e.name, name);
        ASSERT_EQ(plan.outputs[o].level, level);
        const auto expect = [&](std::span<const double> values, const Vec& exact) {
          for (int i = 0; i < e.size; ++i)
            EXPECT_NEAR(values[e.first + i], exact[i], 1e-12 * std::max(1.0, std::abs(exact[i])))
                << all.front().entity << ": " << name << " at " << times()[k];
        };
        expect(e.fixed ? plan.model.fixed_values : f->q(), whole.position(k, name));
        if (e.fixed) continue;
        if (level >= velocity) expect(f->qd(), whole.velocity(k, name));
        if (level >= acceleration) expect(f->qdd(), whole.acceleration(k, name));
      }
    }
  }
}

TEST(PlanSolution, LeavesOutLevelsOfPartsThatNobodyAsksFor) {
  const Plan plan = plan_of({{"axle1/phi6", position}, {"axle1/s12", acceleration}});
  for (const char* id : {"group_automatic_lapack", "block_automatic_klu"}) {
    const auto f = make_formulation(find_variant(id), plan.model);
    for (const DefinedPart& p : parts_of(*f)) EXPECT_EQ(p.level, acceleration);
    f->solve_only(plan.levels);
    std::set<Level> seen;
    for (const DefinedPart& p : parts_of(*f)) {
      const Group& g = plan.model.groups[p.definition.groups.front()];
      const bool lever = g.bodies == std::vector<std::string>{"axle1/6", "axle1/8"};
      EXPECT_EQ(p.level, lever ? position : acceleration) << id << ", " << g.name;
      seen.insert(p.level);
    }
    EXPECT_EQ(seen.size(), 2u) << id;
  }
  // All at once there is one part, and it goes as far as anyone asks.
  const auto global = make_formulation(find_variant("global_automatic_klu"), plan.model);
  global->solve_only(plan.levels);
  for (const DefinedPart& p : parts_of(*global)) EXPECT_EQ(p.level, acceleration);
}

TEST(PlanSolution, OfAPositionSolvesPositionsOnly) {
  const Plan plan = plan_of({{"axle2/s10", position}});
  for (const char* id :
       {"global_automatic_eigen", "group_automatic_klu", "block_automatic_lapack"}) {
    const auto f = make_formulation(find_variant(id), plan.model);
    f->solve_only(plan.levels);
    for (const DefinedPart& p : parts_of(*f)) EXPECT_EQ(p.level, position) << id;
    // Asked for more, they still go no further.
    ASSERT_TRUE(f->step(0.1).ok());
    for (const DefinedPart& p : parts_of(*f))
      for (const int i : p.definition.unknowns) EXPECT_EQ(f->qdd()[i], 0) << id;
  }
}

}  // namespace
}  // namespace desmo::plan_solutions_test
