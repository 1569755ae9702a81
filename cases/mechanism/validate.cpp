#include <algorithm>

#include "cases/mechanism/checks.h"
#include "cases/mechanism/joint_forms.h"
#include "cases/mechanism/names.h"

namespace desmo {

namespace {

using Part = MechanismError::Part;

// Refuses an entity, a point or a vector, that several bodies carry, unless joints connect all of
// these bodies: joints that have the entity in common, or fixed joints.
// - part, joined, common: all for points, or all for vectors
// - fixed: sets of bodies that fixed joints connect
void check(const Mechanism& mechanism, Part part, const Carriers& carriers,
           std::vector<int> Mechanism::Joint::*joined, int JointForm::*common,
           DisjointSets& fixed) {
  const auto pairs = carriers.pairs();
  DisjointSets shared(pairs.size());
  for (const Mechanism::Joint& joint : mechanism.joints) {
    const JointForm& form = *find_joint_form(joint.type, mechanism.dimension);
    for (int k = 0; k < form.*common; ++k) {
      const int entity = (joint.*joined)[k];
      shared.unite(carriers.find({entity, joint.bodies[0]}),
                   carriers.find({entity, joint.bodies[1]}));
    }
  }
  // Fixed joints connect pairs of one entity whose bodies are in one set. Pairs ascend by entity.
  // Index of the latest pair of each set; -1: none so far.
  std::vector<int> last(mechanism.bodies.size(), -1);
  for (int i = 0; i < static_cast<int>(pairs.size()); ++i) {
    int& previous = last[fixed.find(pairs[i].body)];
    if (previous >= 0 && pairs[previous].entity == pairs[i].entity) shared.unite(previous, i);
    previous = i;
  }
  for (int i = 1; i < static_cast<int>(pairs.size()); ++i) {
    if (pairs[i].entity != pairs[i - 1].entity || shared.find(i) == shared.find(i - 1)) continue;
    EntryRefusal{mechanism, part, pairs[i].entity}(
        "is carried by " + in_quotes(mechanism.bodies[pairs[i - 1].body].name) + " and " +
        in_quotes(mechanism.bodies[pairs[i].body].name) +
        ", but no joints say that these share it; add a joint there, or give each body " +
        (part == Part::point ? "a point" : "a vector") + " of its own");
  }
}

// Checks that joints connect all bodies that carry the same point or vector.
void check_sharing(const Mechanism& mechanism, const Carriers& points, const Carriers& vectors) {
  DisjointSets fixed = fixed_bodies(mechanism);
  check(mechanism, Part::point, points, &Mechanism::Joint::points, &JointForm::common_points,
        fixed);
  check(mechanism, Part::vector, vectors, &Mechanism::Joint::vectors, &JointForm::common_vectors,
        fixed);
}

}  // namespace

DisjointSets fixed_bodies(const Mechanism& mechanism) {
  DisjointSets fixed(mechanism.bodies.size());
  for (const Mechanism::Joint& j : mechanism.joints) {
    if (j.type != Mechanism::JointType::fixed) continue;
    const auto [first, later] = std::minmax({fixed.find(j.bodies[0]), fixed.find(j.bodies[1])});
    fixed.unite(later, first);
  }
  return fixed;
}

void EntryRefusal::operator()(const std::string& what) const {
  // Words for the parts, in the order of Part.
  static constexpr const char* kinds[] = {"mechanism", "point",      "vector",  "body",
                                          "joint",     "coordinate", "coupling"};
  const std::string& name = part == Part::point        ? mechanism.points[index].name
                            : part == Part::vector     ? mechanism.vectors[index].name
                            : part == Part::body       ? mechanism.bodies[index].name
                            : part == Part::joint      ? mechanism.joints[index].name
                            : part == Part::coordinate ? mechanism.coordinates[index].name
                            : part == Part::coupling   ? mechanism.couplings[index].name
                                                       : mechanism.name;
  throw MechanismError(
      part, index,
      std::string(kinds[static_cast<int>(part)]) + " " + in_quotes(name) + ": " + what);
}

void validate(const Mechanism& mechanism) {
  const EntryRefusal refuse{mechanism, Part::mechanism, 0};
  if (mechanism.dimension != 2 && mechanism.dimension != 3)
    refuse("the dimension is " + std::to_string(mechanism.dimension) + "; it must be 2 or 3");
  if (mechanism.bodies.empty()) refuse("has no bodies; the first body must be the ground");
  check_names(mechanism);
  check_entities(mechanism);
  const Carriers points(mechanism, &Mechanism::Body::points),
      vectors(mechanism, &Mechanism::Body::vectors);
  check_vectors_along(mechanism, points, vectors);
  check_joints(mechanism, points, vectors);
  check_sharing(mechanism, points, vectors);
  check_coordinates(mechanism, points, vectors);
  check_couplings(mechanism);
}

}  // namespace desmo
