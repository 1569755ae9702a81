// The truck with two axles, of which plans ask for something.
#pragma once

#include <string>
#include <vector>

#include "formulations/model/plan.h"
#include "tests/mechanisms.h"

namespace desmo {

/// An entity that is asked for by its name.
struct Named {
  std::string entity;
  Level level;
};

inline const Model& two_axles() {
  static const Model m = truck_model(2);
  return m;
}

inline std::vector<Output> outputs(const std::vector<Named>& asked) {
  std::vector<Output> result;
  for (const auto& [entity, level] : asked) result.push_back({two_axles().find(entity), level});
  return result;
}

/// Returns all whose names begin so, with accelerations.
inline std::vector<Named> all_of(const std::string& prefix) {
  std::vector<Named> result;
  for (const Entity& e : two_axles().entities)
    if (e.name.starts_with(prefix)) result.push_back({e.name, Level::acceleration});
  return result;
}

inline Plan plan_of(const std::vector<Named>& asked, PlanExtent extent = PlanExtent::outputs) {
  return make_plan(two_axles(), outputs(asked), extent);
}

inline Level level_of(const Plan& plan, const std::string& name) {
  return plan.levels[plan.model.entities[plan.model.find(name)].first];
}

/// Requests of every kind; the last is empty, which asks for everything.
inline const std::vector<std::vector<Named>>& requests() {
  using enum Level;
  static const std::vector<std::vector<Named>> all{
      {{"axle1/WL", position}},
      {{"axle2/s10", velocity}},
      {{"axle1/s10", acceleration},
       {"axle1/s12", acceleration},
       {"axle2/s10", acceleration},
       {"axle2/s12", acceleration}},
      {{"axle1/phi6", position}, {"axle1/s12", acceleration}},
      {{"axle1/u8", position}, {"axle1/phi6", acceleration}},  // of one group
      {{"axle1/phi7", position}, {"axle1/phi7", velocity}},
      {{"axle2/T13", acceleration}},  // fixed
      {{"axle2/T13", velocity}, {"axle2/WR", position}},
      {{"axle1/zR", acceleration}},  // driven
      {{"axle1/zR", velocity}, {"axle2/s10", velocity}},
      {{"y1", acceleration}},  // held
      all_of("axle2/"),
      {},
  };
  return all;
}

}  // namespace desmo
