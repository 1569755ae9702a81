// Submodels that move independently: what each has of the whole, and what that costs.

#include "formulations/verification/run/submodels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "formulations/model/plan.h"
#include "formulations/model/scales.h"
#include "tests/checked/rows.h"
#include "tests/flaps.h"
#include "tests/mechanisms.h"

namespace desmo::submodels_test {
namespace {

/// Returns models with the number of their independent mechanisms. Equations between constants of
/// the flaps are left out.
std::vector<std::pair<Model, int>> models() {
  return {{make_model(scene_file("two_parallelograms")), 2},
          {truck_model(3), 3},
          {make_model(parse_scene(flaps(4, 4e-7), "flaps.json", "")), 4}};
}

std::vector<std::string> names(const auto& members) {
  std::vector<std::string> result;
  for (const auto& member : members) result.push_back(member.name);
  return result;
}

/// Returns those of the names of the whole's members.
std::vector<std::string> names_at(const auto& whole, const std::vector<int>& positions) {
  std::vector<std::string> result;
  for (const int i : positions) result.push_back(whole[i].name);
  return result;
}

std::vector<std::string> driven_names(const Model& m) {
  std::vector<std::string> result;
  for (const Driver& d : m.drivers) result.push_back(m.entities[d.coordinate].name);
  return result;
}

/// Expects the numbers of a fixed entity to be those of the whole's.
void expect_same_values(const Model& m, const Entity& e, const Model& whole, EntityId id) {
  const Entity& original = whole.entities[id];
  if (!e.fixed) return;
  for (int i = 0; i < e.size; ++i) {
    EXPECT_EQ(m.fixed_values[e.first + i], whole.fixed_values[original.first + i]) << e.name;
    EXPECT_EQ(m.fixed_remainders[e.first + i].correction,
              whole.fixed_remainders[original.first + i].correction);
  }
}

/// All but fixed entities that no equation reads.
TEST(Submodels, ArePlansOfWhatMovesInThemAndOfWhatNeverMoves) {
  for (const auto& [whole, mechanisms] : models()) {
    SCOPED_TRACE(whole.name);
    std::vector<int> owners(whole.entities.size());
    const std::vector<Submodel> submodels = independent_submodels(whole, {});
    EXPECT_EQ(std::ssize(submodels), mechanisms);
    for (const Submodel& s : submodels) {
      for (const EntityId e : s.members.entities) ++owners[e];
      std::vector<Output> asked;
      for (EntityId e = 0; e < static_cast<EntityId>(whole.entities.size()); ++e)
        if (whole.is_at_rest(e) || std::ranges::binary_search(s.members.entities, e))
          asked.push_back({e, Level::acceleration});
      const Model plan = make_plan(whole, asked).model;
      EXPECT_EQ(names(s.model.groups), names(plan.groups));
      EXPECT_EQ(names(s.model.groups), names_at(whole.groups, s.groups));
      EXPECT_EQ(names(s.model.constraints), names(plan.constraints));
      EXPECT_EQ(names(s.model.constraints), names_at(whole.constraints, s.members.constraints));
      EXPECT_EQ(names(s.model.entities), names_at(whole.entities, s.members.entities));
      EXPECT_EQ(driven_names(s.model), driven_names(plan));
      EXPECT_EQ(s.model.estimate, plan.estimate);
      for (int i = 0; i < s.model.coordinates(); ++i)
        EXPECT_EQ(s.model.estimate[i], whole.estimate[s.coordinates.at(i)]);
      for (std::size_t i = 0; i < s.members.entities.size(); ++i)
        expect_same_values(s.model, s.model.entities[i], whole, s.members.entities[i]);
      EXPECT_EQ(nominal_size(s.model), nominal_size(plan));
    }
    for (EntityId e = 0; e < static_cast<EntityId>(whole.entities.size()); ++e)
      if (!whole.is_at_rest(e)) EXPECT_EQ(owners[e], 1) << whole.entities[e].name;
  }
}

/// The whole has seven fixed points for each axle. Of others' an axle has the six outermost at
/// most, and all have one constant axis.
TEST(Submodels, GrowWithTheWholeAndNotWithItsSquare) {
  constexpr int axles = 16;
  const Model whole = truck_model(axles);
  std::size_t entities = 0;
  for (const Submodel& s : independent_submodels(whole, {})) entities += s.model.entities.size();
  EXPECT_LE(entities, whole.entities.size() + axles * (6 + 1));
}

}  // namespace
}  // namespace desmo::submodels_test
