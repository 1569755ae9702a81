// Plans keep entities as far as a request needs them, and no others.

#include "formulations/model/plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/modelling/common.h"
#include "tests/modelling/plan.h"
#include "tests/overconstrained.h"

namespace desmo::plan_test {
namespace {

using enum Level;
using Names = std::set<std::string>;

Names names(const Model& m) {
  Names result;
  for (const Entity& e : m.entities) result.insert(e.name);
  return result;
}

TEST(Plan, DropsWhatNothingAskedDependsOn) {
  const Plan plan = plan_of({{"axle1/WL", position}});
  const Names kept = names(plan.model);
  // The axle's pose, its arm and rods as far as they hold it.
  for (const char* needed :
       {"axle1/WL", "axle1/y2", "axle1/z2", "axle1/S", "axle1/C4", "axle1/C5", "axle1/WR",
        "axle1/R", "axle1/G4", "axle1/G5", "axle1/zL", "axle1/zR", "y1"})
    EXPECT_TRUE(kept.contains(needed)) << needed;
  // Vectors that only complete frames (no point that holds the axle is offset along x2), bodies
  // that hang on the axle, and the other axle.
  for (const char* idle : {"axle1/x2", "axle1/n3", "axle1/n4", "axle1/n5", "axle1/A6", "axle1/phi6",
                           "axle1/s10", "axle1/T11", "axle2/WL", "axle2/zL"})
    EXPECT_FALSE(kept.contains(idle)) << idle;
  EXPECT_EQ(plan.model.drivers.size(), 2u);
  EXPECT_LT(plan.model.coordinates(), 41 + 3);
  EXPECT_EQ(plan.levels.size(), static_cast<std::size_t>(plan.model.coordinates()));
  for (const std::string& name : kept)
    EXPECT_TRUE(name.starts_with("axle1/") || name.ends_with("y1")) << name;
}

TEST(Plan, DropsDriversThatAreNotNeeded) {
  const auto drivers = [](const char* entity) {
    const Plan plan = plan_of({{entity, position}});
    Names result;
    for (const Driver& d : plan.model.drivers)
      result.insert(plan.model.entities[d.coordinate].name);
    return result;
  };
  EXPECT_EQ(drivers("axle2/s10"), (Names{"axle2/zL", "axle2/zR"}));
  EXPECT_EQ(drivers("axle1/zL"), Names{"axle1/zL"});
  EXPECT_EQ(drivers("y1"), Names{});
  EXPECT_EQ(drivers("axle1/R"), Names{});
}

TEST(Plan, KeepsConstraintsAndEntitiesWhole) {
  for (const std::vector<Named>& asked : requests()) {
    const Plan plan = plan_of(asked);
    const Model& m = plan.model;
    EXPECT_NO_THROW(validate(m));
    for (const Entity& e : m.entities)
      EXPECT_EQ(e.size, two_axles().entities[two_axles().find(e.name)].size);
    int equations = 0, independent = 0;
    for (const Constraint& c : m.constraints) {
      const auto original = std::ranges::find(two_axles().constraints, c.name, &Constraint::name);
      ASSERT_NE(original, two_axles().constraints.end());
      EXPECT_EQ(kept_rows(c), kept_rows(*original)) << c.name;
      EXPECT_EQ(values_of(c), values_of(*original)) << c.name;
      equations += kept_rows(c);
    }
    for (const bool b : independent_coordinates(m)) independent += b;
    EXPECT_EQ(equations, m.coordinates() - independent);
  }
}

TEST(Plan, OfEverythingIsTheWhole) {
  const Plan plan = plan_of({});
  EXPECT_EQ(plan.model.coordinates(), two_axles().coordinates());
  EXPECT_EQ(names(plan.model), names(two_axles()));
  EXPECT_EQ(plan.model.constraints.size(), two_axles().constraints.size());
  EXPECT_TRUE(std::ranges::all_of(plan.levels, [](Level l) { return l == acceleration; }));
  EXPECT_EQ(plan.level(), acceleration);
  for (const Plan::GroupUse& g : plan.groups) {
    EXPECT_EQ(g.kept_unknowns, g.unknowns) << g.name;
    EXPECT_EQ(g.kept_blocks, g.blocks) << g.name;
    EXPECT_TRUE(g.dropped.empty()) << g.name;
  }
}

TEST(Plan, OfAFixedPointSolvesNothing) {
  const Plan plan = plan_of({{"axle2/T13", velocity}});
  EXPECT_EQ(plan.model.coordinates(), 0);
  EXPECT_TRUE(plan.model.groups.empty());
  ASSERT_EQ(plan.outputs.size(), 1u);
  EXPECT_TRUE(plan.model.entities[plan.outputs[0].entity].fixed);
}

TEST(Plan, SaysWhatBecameOfEachGroup) {
  const Plan plan = plan_of({{"axle1/s10", velocity}});
  ASSERT_EQ(plan.groups.size(), two_axles().groups.size());
  const auto use = [&](const char* name) {
    return *std::ranges::find(plan.groups, name, &Plan::GroupUse::name);
  };
  const Plan::GroupUse axle = use("axle1/SG-I"), damper = use("axle1/SG-IV");
  const Plan::GroupUse stabiliser = use("axle1/SG-II"), other = use("axle2/SG-I");
  EXPECT_EQ(axle.unknowns, 39);
  EXPECT_EQ(axle.blocks, 12);
  EXPECT_GT(axle.kept_unknowns, 0);
  EXPECT_LT(axle.kept_unknowns, 39);
  EXPECT_LT(axle.kept_blocks, 12);
  EXPECT_EQ(axle.level, velocity);
  EXPECT_EQ(axle.serves, "axle1/s10");
  EXPECT_EQ(damper.unknowns, 16);
  EXPECT_EQ(damper.level, velocity);
  EXPECT_TRUE(std::ranges::find(damper.kept, "axle1/s10") != damper.kept.end());
  EXPECT_TRUE(std::ranges::find(damper.dropped, "axle1/n11") != damper.dropped.end());
  for (const Plan::GroupUse& g : {stabiliser, other}) {
    EXPECT_EQ(g.kept_unknowns, 0) << g.name;
    EXPECT_EQ(g.kept_blocks, 0) << g.name;
    EXPECT_TRUE(g.kept.empty()) << g.name;
    EXPECT_EQ(g.serves, "") << g.name;
  }
}

/// Names of the groups that nobody looks at.
Names unseen(const Plan& plan) {
  Names result;
  for (const Plan::GroupUse& group : plan.groups)
    if (group.may_lock) result.insert(group.name);
  return result;
}

TEST(Plan, NamesGroupsThatMightLockUnseen) {
  const auto plan = [](const char* entity) { return plan_of({{entity, position}}); };
  EXPECT_TRUE(unseen(plan_of({})).empty());
  const Names beside_axle = unseen(plan("axle1/WL"));
  EXPECT_TRUE(beside_axle.contains("axle1/SG-II"));
  EXPECT_TRUE(beside_axle.contains("axle2/SG-I"));
  EXPECT_TRUE(unseen(plan("axle1/zL")).contains("axle1/SG-I"));

  // A dyad is solved as a whole, or not at all.
  const Model chain = four_bar_model(3);
  const Plan second = make_plan(chain, std::vector{Output{chain.find("dyad2/C"), position}});
  EXPECT_EQ(unseen(second).size(), 1u);
  EXPECT_TRUE(
      unseen(make_plan(chain, std::vector{Output{chain.find("dyad3/C"), position}})).empty());
}

TEST(Plan, OfTheMechanismSolvesPositionsOfAllElse) {
  const Plan plan = plan_of({{"axle1/s10", acceleration}}, PlanExtent::mechanism);
  EXPECT_EQ(names(plan.model), names(two_axles()));
  EXPECT_EQ(plan.outputs.size(), 1u);
  EXPECT_TRUE(unseen(plan).empty());
  EXPECT_EQ(level_of(plan, "axle1/s10"), acceleration);
  EXPECT_EQ(level_of(plan, "axle1/WL"), acceleration);
  EXPECT_EQ(level_of(plan, "axle2/WL"), position);
  EXPECT_EQ(level_of(plan, "axle2/s10"), position);
}

TEST(Plan, KeepsWhatLeftOutEquationsRead) {
  const Model m = make_model(parallel_cranks(1, 17, true));
  const auto left_out = [](const Model& of) {
    return std::ranges::count_if(of.constraints, [](const Constraint& c) { return c.left_out; });
  };
  const std::vector<Output> asked{{m.find("B2"), velocity}};
  const Plan needed = make_plan(m, asked);
  const Plan checked = make_plan(m, asked, PlanExtent::left_out_equations);
  EXPECT_LT(left_out(needed.model), left_out(m));
  EXPECT_EQ(left_out(checked.model), left_out(m));
  EXPECT_EQ(level_of(checked, "B2"), velocity);
  EXPECT_EQ(level_of(checked, "B3"), position);
  // Of groups that nobody needs, nothing is kept.
  const Plan truck = plan_of({{"axle1/WL", position}}, PlanExtent::left_out_equations);
  EXPECT_FALSE(names(truck.model).contains("axle2/WL"));
}

TEST(Plan, AsksUpstreamForTheLevelOfWhatDependsOnIt) {
  // Angle of one lever in position, length of one damper with acceleration: what both need, the
  // axle, is needed with acceleration; the lever only in position.
  const Plan plan = plan_of({{"axle1/phi6", position}, {"axle1/s12", acceleration}});
  for (const char* deep : {"axle1/WL", "axle1/x2", "axle1/A12", "axle1/s12", "axle1/zL", "y1"})
    EXPECT_EQ(level_of(plan, deep), acceleration) << deep;
  for (const char* shallow : {"axle1/A6", "axle1/B6", "axle1/phi6"})
    EXPECT_EQ(level_of(plan, shallow), position) << shallow;
  EXPECT_EQ(plan.level(), acceleration);
}

}  // namespace
}  // namespace desmo::plan_test
