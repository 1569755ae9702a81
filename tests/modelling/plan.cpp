// What a request needs is solved as far as it is needed, and nothing else; what it delivers is what
// the whole solution delivers.

#include "formulations/planning/plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "cases/generators/cases.h"
#include "formulations/stepping/formulation_core.h"
#include "formulations/structure/partition.h"
#include "formulations/variants.h"
#include "tests/every_variant.h"
#include "tests/mechanisms.h"
#include "tests/overconstrained.h"

namespace desmo::plan_test {
namespace {

constexpr double duration = 0.4, step = 0.01;

struct Named {
  const char* entity;
  Level level;
};

struct Wish {
  const char* name;
  std::vector<Named> asked;
};

/// Requests to the truck with two axles.
const std::vector<Wish>& wishes() {
  using enum Level;
  static const std::vector<Wish> list{
      {"wheel centre", {{"axle1/WL", position}}},
      {"one damper's velocity", {{"axle2/s10", velocity}}},
      {"all dampers",
       {{"axle1/s10", acceleration},
        {"axle1/s12", acceleration},
        {"axle2/s10", acceleration},
        {"axle2/s12", acceleration}}},
      {"two levels", {{"axle1/phi6", position}, {"axle1/s12", acceleration}}},
      {"two levels in one group", {{"axle1/u8", position}, {"axle1/phi6", acceleration}}},
      {"one thing twice", {{"axle1/phi7", position}, {"axle1/phi7", velocity}}},
      {"fixed point", {{"axle2/T13", acceleration}}},
      {"fixed point beside another", {{"axle2/T13", velocity}, {"axle2/WR", position}}},
      {"driven coordinate", {{"axle1/zR", acceleration}}},
      {"driven coordinate beside another", {{"axle1/zR", velocity}, {"axle2/s10", velocity}}},
      {"held vector", {{"y1", acceleration}}},
      {"nothing, that is everything", {}},
  };
  return list;
}

std::vector<Output> asked_of(const Model& m, const Wish& wish) {
  std::vector<Output> result;
  for (const auto& [entity, level] : wish.asked) result.push_back({m.find(entity), level});
  return result;
}

/// Everything on the second axle.
std::vector<Output> second_axle(const Model& m) {
  std::vector<Output> result;
  for (EntityId e = 0; e < static_cast<EntityId>(m.entities.size()); ++e)
    if (m.entities[e].name.starts_with("axle2/")) result.push_back({e, Level::acceleration});
  return result;
}

std::set<std::string> names(const Model& m) {
  std::set<std::string> result;
  for (const Entity& e : m.entities) result.insert(e.name);
  return result;
}

const Model& whole() {
  static const Model m = truck_model(2);
  return m;
}

/// The motion of the whole truck, to which every plan is compared.
struct Motions {
  std::vector<std::vector<double>> q, qd, qdd;
};
const Motions& whole_motion() {
  static const Motions all = [] {
    const auto f = make_formulation(find_variant("group_automatic_eigen"), whole(), {1e-13, 25});
    Motions m;
    for (int i = 0; i * step <= duration; ++i) {
      EXPECT_TRUE(f->step(i * step).ok());
      m.q.emplace_back(f->q().begin(), f->q().end());
      m.qd.emplace_back(f->qd().begin(), f->qd().end());
      m.qdd.emplace_back(f->qdd().begin(), f->qdd().end());
    }
    return m;
  }();
  return all;
}

void expect_outputs_of_the_whole(const Plan& plan, const std::vector<Output>& asked,
                                 const Variant& variant, const std::string& what) {
  const auto f = make_formulation(variant, plan.model, Settings{1e-13, 25});
  f->solve_only(plan.levels);
  const Motions& expected = whole_motion();
  for (std::size_t k = 0; k < expected.q.size() && !testing::Test::HasFailure(); ++k) {
    const Summary s = f->step(k * step, plan.level());
    ASSERT_TRUE(s.ok()) << what << ": " << describe(s, plan.model);
    ASSERT_EQ(plan.outputs.size(), asked.size());
    for (std::size_t o = 0; o < asked.size(); ++o) {
      const Entity& from = whole().entities[asked[o].entity];
      const Entity& to = plan.model.entities[plan.outputs[o].entity];
      ASSERT_EQ(to.name, from.name);
      ASSERT_EQ(plan.outputs[o].level, asked[o].level);
      ASSERT_EQ(to.fixed, from.fixed);
      for (int i = 0; i < from.size; ++i) {
        const int a = from.first + i, b = to.first + i;
        if (from.fixed) {
          EXPECT_EQ(plan.model.fixed_values[b], whole().fixed_values[a]);
          continue;
        }
        const auto near = [&](double actual, double exact, const char* level) {
          EXPECT_NEAR(actual, exact, 1e-12 * std::max(1.0, std::abs(exact)))
              << what << ": " << level << " of " << from.name << " at " << k * step;
        };
        near(f->q()[b], expected.q[k][a], "position");
        if (asked[o].level >= Level::velocity) near(f->qd()[b], expected.qd[k][a], "velocity");
        if (asked[o].level >= Level::acceleration)
          near(f->qdd()[b], expected.qdd[k][a], "acceleration");
      }
    }
  }
}

std::vector<Output> everything(const Model& m) {
  std::vector<Output> result;
  for (EntityId e = 0; e < static_cast<EntityId>(m.entities.size()); ++e)
    result.push_back({e, Level::acceleration});
  return result;
}

class EveryPlan : public EveryVariant {};

TEST_P(EveryPlan, DeliversWhatTheWholeSolutionDoes) {
  for (const Wish& wish : wishes()) {
    SCOPED_TRACE(wish.name);
    const std::vector<Output> asked = asked_of(whole(), wish);
    const Plan plan = make_plan(whole(), asked);
    try {
      expect_outputs_of_the_whole(plan, asked.empty() ? everything(whole()) : asked, GetParam(),
                                  wish.name);
    } catch (const std::exception& e) {
      ADD_FAILURE() << e.what();
    }
  }
  const std::vector<Output> axle = second_axle(whole());
  expect_outputs_of_the_whole(make_plan(whole(), axle), axle, GetParam(), "second axle");
}

INSTANTIATE_TEST_SUITE_P(Table, EveryPlan, testing::ValuesIn(tested_variants()),
                         EveryVariant::name);

TEST(Plan, DropsWhatNothingAskedDependsOn) {
  const Plan plan = make_plan(whole(), asked_of(whole(), {"", {{"axle1/WL", Level::position}}}));
  const std::set<std::string> kept = names(plan.model);
  // The axle's pose, its arm and rods as far as they hold it.
  for (const char* needed :
       {"axle1/WL", "axle1/y2", "axle1/z2", "axle1/S", "axle1/C4", "axle1/C5", "axle1/WR",
        "axle1/R", "axle1/G4", "axle1/G5", "axle1/zL", "axle1/zR", "y1"})
    EXPECT_TRUE(kept.contains(needed)) << needed;
  // What only completes frames (x2: no point that holds the axle is offset along it), what hangs on
  // the axle, and the other axle.
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
    const Plan plan = make_plan(whole(), asked_of(whole(), {"", {{entity, Level::position}}}));
    std::set<std::string> result;
    for (const Driver& d : plan.model.drivers)
      result.insert(plan.model.entities[d.coordinate].name);
    return result;
  };
  using Names = std::set<std::string>;
  EXPECT_EQ(drivers("axle2/s10"), (Names{"axle2/zL", "axle2/zR"}));
  EXPECT_EQ(drivers("axle1/zL"), Names{"axle1/zL"});
  EXPECT_EQ(drivers("y1"), Names{});
  EXPECT_EQ(drivers("axle1/R"), Names{});
}

TEST(Plan, KeepsConstraintsAndEntitiesWhole) {
  for (const Wish& wish : wishes()) {
    const Plan plan = make_plan(whole(), asked_of(whole(), wish));
    const Model& m = plan.model;
    EXPECT_NO_THROW(validate(m));
    for (const Entity& e : m.entities)
      EXPECT_EQ(e.size, whole().entities[whole().find(e.name)].size);
    int equations = 0, independent = 0;
    for (const Constraint& c : m.constraints) {
      const auto original = std::ranges::find(whole().constraints, c.name, &Constraint::name);
      ASSERT_NE(original, whole().constraints.end());
      EXPECT_EQ(kept_rows(c), kept_rows(*original)) << c.name;
      EXPECT_EQ(c.constants, original->constants) << c.name;
      equations += kept_rows(c);
    }
    for (const bool b : independent_coordinates(m)) independent += b;
    EXPECT_EQ(equations, m.coordinates() - independent) << wish.name;
  }
}

TEST(Plan, OfEverythingIsTheWhole) {
  const Plan plan = make_plan(whole(), {});
  EXPECT_EQ(plan.model.coordinates(), whole().coordinates());
  EXPECT_EQ(names(plan.model), names(whole()));
  EXPECT_EQ(plan.model.constraints.size(), whole().constraints.size());
  EXPECT_TRUE(std::ranges::all_of(plan.levels, [](Level l) { return l == Level::acceleration; }));
  EXPECT_EQ(plan.level(), Level::acceleration);
  for (const Plan::GroupUse& g : plan.groups) {
    EXPECT_EQ(g.kept_unknowns, g.unknowns) << g.name;
    EXPECT_EQ(g.kept_blocks, g.blocks) << g.name;
    EXPECT_TRUE(g.dropped.empty()) << g.name;
  }
}

TEST(Plan, OfAFixedPointSolvesNothing) {
  const Plan plan = make_plan(whole(), asked_of(whole(), {"", {{"axle2/T13", Level::velocity}}}));
  EXPECT_EQ(plan.model.coordinates(), 0);
  EXPECT_TRUE(plan.model.groups.empty());
  ASSERT_EQ(plan.outputs.size(), 1u);
  EXPECT_TRUE(plan.model.entities[plan.outputs[0].entity].fixed);
}

TEST(Plan, SaysWhatBecameOfEachGroup) {
  const Plan plan = make_plan(whole(), asked_of(whole(), {"", {{"axle1/s10", Level::velocity}}}));
  ASSERT_EQ(plan.groups.size(), whole().groups.size());
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
  EXPECT_EQ(axle.level, Level::velocity);
  EXPECT_EQ(axle.serves, "axle1/s10");
  EXPECT_EQ(damper.unknowns, 16);
  EXPECT_EQ(damper.level, Level::velocity);
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
std::set<std::string> unseen(const Plan& plan) {
  std::set<std::string> result;
  for (const GroupId g : plan.unseen_groups()) result.insert(plan.groups[g].name);
  return result;
}

TEST(Plan, NamesGroupsThatMightLockUnseen) {
  const auto plan = [](const char* entity) {
    return make_plan(whole(), asked_of(whole(), {"", {{entity, Level::position}}}));
  };
  EXPECT_TRUE(unseen(make_plan(whole(), {})).empty());
  const std::set<std::string> beside_axle = unseen(plan("axle1/WL"));
  EXPECT_TRUE(beside_axle.contains("axle1/SG-II"));
  EXPECT_TRUE(beside_axle.contains("axle2/SG-I"));
  EXPECT_TRUE(unseen(plan("axle1/zL")).contains("axle1/SG-I"));

  // A dyad is solved as a whole, or not at all.
  const Model chain = four_bar_model(3);
  const Plan second = make_plan(chain, std::vector{Output{chain.find("dyad2/C"), Level::position}});
  EXPECT_EQ(unseen(second).size(), 1u);
  EXPECT_TRUE(make_plan(chain, std::vector{Output{chain.find("dyad3/C"), Level::position}})
                  .unseen_groups()
                  .empty());
}

TEST(Plan, OfTheMechanismSolvesPositionsOfAllElse) {
  using enum Level;
  const std::vector<Output> asked = asked_of(whole(), {"", {{"axle1/s10", acceleration}}});
  const Plan plan = make_plan(whole(), asked, PlanExtent::mechanism);
  EXPECT_EQ(names(plan.model), names(whole()));
  EXPECT_EQ(plan.outputs.size(), 1u);
  EXPECT_TRUE(plan.unseen_groups().empty());
  const auto level_of = [&](const char* name) {
    return plan.levels[plan.model.entities[plan.model.find(name)].first];
  };
  EXPECT_EQ(level_of("axle1/s10"), acceleration);
  EXPECT_EQ(level_of("axle1/WL"), acceleration);
  EXPECT_EQ(level_of("axle2/WL"), position);
  EXPECT_EQ(level_of("axle2/s10"), position);
}

TEST(Plan, KeepsWhatLeftOutEquationsRead) {
  const Model m = make_model(parallel_cranks(1, 17, true));
  const auto left_out = [](const Model& of) {
    return std::ranges::count_if(of.constraints, [](const Constraint& c) { return c.left_out; });
  };
  const std::vector<Output> asked{{m.find("B2"), Level::velocity}};
  const Plan needed = make_plan(m, asked);
  const Plan checked = make_plan(m, asked, PlanExtent::left_out_equations);
  EXPECT_LT(left_out(needed.model), left_out(m));
  EXPECT_EQ(left_out(checked.model), left_out(m));
  const auto level_of = [&](const char* name) {
    return checked.levels[checked.model.entities[checked.model.find(name)].first];
  };
  EXPECT_EQ(level_of("B2"), Level::velocity);
  EXPECT_EQ(level_of("B3"), Level::position);
  // Of groups that nobody needs, nothing is kept.
  const Plan truck = make_plan(whole(), asked_of(whole(), {"", {{"axle1/WL", Level::position}}}),
                               PlanExtent::left_out_equations);
  EXPECT_FALSE(names(truck.model).contains("axle2/WL"));
}

TEST(Plan, AsksUpstreamForTheLevelOfWhatDependsOnIt) {
  // Angle of one lever in position, length of one damper with acceleration: what both need, the
  // axle, is needed with acceleration; the lever only in position.
  using enum Level;
  const Plan plan = make_plan(
      whole(), asked_of(whole(), {"", {{"axle1/phi6", position}, {"axle1/s12", acceleration}}}));
  const auto level_of = [&](const char* name) {
    return plan.levels[plan.model.entities[plan.model.find(name)].first];
  };
  for (const char* deep : {"axle1/WL", "axle1/x2", "axle1/A12", "axle1/s12", "axle1/zL", "y1"})
    EXPECT_EQ(level_of(deep), acceleration) << deep;
  for (const char* shallow : {"axle1/A6", "axle1/B6", "axle1/phi6"})
    EXPECT_EQ(level_of(shallow), position) << shallow;
  EXPECT_EQ(plan.level(), acceleration);
}

TEST(Plan, LeavesOutLevelsOfPartsThatNobodyAsksFor) {
  using enum Level;
  const Plan plan = make_plan(
      whole(), asked_of(whole(), {"", {{"axle1/phi6", position}, {"axle1/s12", acceleration}}}));
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

TEST(Plan, OfAPositionSolvesPositionsOnly) {
  const Plan plan = make_plan(whole(), asked_of(whole(), {"", {{"axle2/s10", Level::position}}}));
  for (const char* id :
       {"global_automatic_eigen", "group_automatic_klu", "block_automatic_lapack"}) {
    const auto f = make_formulation(find_variant(id), plan.model);
    f->solve_only(plan.levels);
    for (const DefinedPart& p : parts_of(*f)) EXPECT_EQ(p.level, Level::position) << id;
    // Asked for more, they still go no further.
    ASSERT_TRUE(f->step(0.1).ok());
    for (const DefinedPart& p : parts_of(*f))
      for (const int i : p.definition.unknowns) EXPECT_EQ(f->qdd()[i], 0) << id;
  }
}

TEST(Plan, TakesWhatASceneAsksFor) {
  Scene s = truck_suspension(1);
  const auto index = [](const auto& list, const char* name) {
    for (int i = 0; i < static_cast<int>(list.size()); ++i)
      if (list[i].name == name) return i;
    return -1;
  };
  using enum RequestedEntity::Kind;
  s.request = {{point, index(s.mechanism.points, "axle1/B6"), Level::velocity},
               {vector, index(s.mechanism.vectors, "axle1/e6"), Level::position},
               {coordinate, index(s.mechanism.coordinates, "axle1/s12"), Level::acceleration}};
  const Model m = make_model(s);
  const std::vector<Output> asked = outputs_of(s, m);
  ASSERT_EQ(asked.size(), 3u);
  EXPECT_EQ(m.entities[asked[0].entity].name, "axle1/B6");
  EXPECT_EQ(m.entities[asked[1].entity].name, "axle1/e6");
  EXPECT_EQ(m.entities[asked[2].entity].name, "axle1/s12");
  EXPECT_EQ(asked[0].level, Level::velocity);
  EXPECT_EQ(make_plan(m, asked).level(), Level::acceleration);
}

}  // namespace
}  // namespace desmo::plan_test
