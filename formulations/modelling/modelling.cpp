#include "formulations/modelling/modelling.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "formulations/model/partition.h"
#include "formulations/modelling/bodies/rigid_bodies.h"
#include "formulations/modelling/equations/candidates.h"
#include "formulations/modelling/groups/structure.h"
#include "formulations/modelling/independence/independence.h"

namespace desmo {

ModellingResult model_mechanism(const Mechanism& mechanism, const std::vector<Motion>& motions,
                                Modelling modelling) {
  validate(mechanism);
  require_representable(mechanism);
  const auto drivers =
      std::ranges::count(mechanism.coordinates, true, &Mechanism::Coordinate::driven);
  if (static_cast<std::size_t>(drivers) != motions.size())
    throw std::invalid_argument(mechanism.name + ": " + std::to_string(motions.size()) +
                                " motions for " + std::to_string(drivers) + " drivers");
  const RigidBodies rigid = find_rigid_bodies(mechanism);
  const Structure structure = find_structure(mechanism, rigid);
  ModellingResult result{make_candidate_equations(mechanism, rigid, structure, motions, modelling),
                         {}};
  Model& m = result.model;

  const std::size_t constant = m.groups.size() - structure.groups.size();
  std::vector<int> surplus(constant, 0);
  for (const StructuralGroup& g : structure.groups) surplus.push_back(g.restrictions - g.freedoms);
  result.left_out = leave_out_dependent(m, surplus);
  result.idle = find_idle_freedoms(mechanism, rigid);
  keep_derivations(m);
  validate(m);
  return result;
}

Model make_model(const Scene& scene, Modelling modelling) {
  return model_mechanism(scene.mechanism, scene.motions, modelling).model;
}

}  // namespace desmo
