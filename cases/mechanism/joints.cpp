#include "cases/mechanism/checks.h"
#include "cases/mechanism/directions.h"
#include "cases/mechanism/joint_forms.h"
#include "cases/mechanism/names.h"

namespace desmo {
namespace {

using Part = MechanismError::Part;

std::string counted(std::size_t count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

const JointForm& form_of(const Mechanism& mechanism, int i) {
  const EntryRefusal refuse{mechanism, Part::joint, i};
  const Mechanism::Joint& joint = mechanism.joints[i];
  if (const JointForm* form = find_joint_form(joint.type, mechanism.dimension)) return *form;
  const JointForm* elsewhere = find_joint_form(joint.type, 5 - mechanism.dimension);
  if (!elsewhere) refuse("has a type that does not exist");
  refuse(std::string(elsewhere->name) + " joints exist only " +
         (mechanism.dimension == 2 ? "in space, this mechanism is plane"
                                   : "in the plane, this mechanism is spatial") +
         "; choose another type");
}

// Checks one list of a joint, its points or its vectors. Both bodies must carry each common entity.
// The first body must carry the first own entity, and the second body the second one.
template <class Entry>
void check_carried(const Mechanism& mechanism, int i, const JointForm& form,
                   const std::vector<int>& joined, int common, const std::vector<Entry>& entries,
                   const Carriers& carriers, const char* kind) {
  const EntryRefusal refuse{mechanism, Part::joint, i};
  const Mechanism::Joint& joint = mechanism.joints[i];
  for (int k = 0; k < static_cast<int>(joined.size()); ++k) {
    if (!is_in(joined[k], entries)) refuse(std::string("joins a ") + kind + " that does not exist");
    if (k > 0 && joined[k] == joined[0])
      refuse(std::string("lists the ") + kind + " " + in_quotes(entries[joined[k]].name) +
             " twice; name two different ones");
    for (int side = 0; side < 2; ++side) {
      if (k >= common && side != k - common) continue;
      if (carriers.carries(joint.bodies[side], joined[k])) continue;
      refuse(std::string("the ") + kind + " " + in_quotes(entries[joined[k]].name) +
             " is not carried by " + in_quotes(mechanism.bodies[joint.bodies[side]].name) + "; " +
             std::string(form.name) + " takes " + std::string(form.takes));
    }
  }
}

// Checks that two common points (hinge) differ, so that they determine the axis. Checks that two
// common vectors (prismatic in space) are not parallel, so that they prevent rotation.
void check_axis(const Mechanism& mechanism, int i, const JointForm& form) {
  const EntryRefusal refuse{mechanism, Part::joint, i};
  if (form.common_points == 2) {
    const Mechanism::Point &p = mechanism.points[mechanism.joints[i].points[0]],
                           &q = mechanism.points[mechanism.joints[i].points[1]];
    if (!direction(p.position, q.position))
      refuse("its points " + in_quotes(p.name) + " and " + in_quotes(q.name) +
             " coincide; the axis goes through two different places");
  }
  if (form.common_vectors < 2) return;
  const std::vector<int>& vectors = mechanism.joints[i].vectors;
  if (!common_normal(mechanism.vectors[vectors[0]].direction,
                     mechanism.vectors[vectors[1]].direction))
    refuse("its vectors " + in_quotes(mechanism.vectors[vectors[0]].name) + " and " +
           in_quotes(mechanism.vectors[vectors[1]].name) +
           " are parallel; the second must cross the axis");
}

}  // namespace

void check_joints(const Mechanism& mechanism, const Carriers& points, const Carriers& vectors) {
  for (int i = 0; i < static_cast<int>(mechanism.joints.size()); ++i) {
    const EntryRefusal refuse{mechanism, Part::joint, i};
    const Mechanism::Joint& joint = mechanism.joints[i];
    const JointForm& form = form_of(mechanism, i);
    if (!is_in(joint.bodies[0], mechanism.bodies) || !is_in(joint.bodies[1], mechanism.bodies))
      refuse("joins a body that does not exist");
    if (joint.bodies[0] == joint.bodies[1])
      refuse("joins " + in_quotes(mechanism.bodies[joint.bodies[0]].name) +
             " with itself; name two different bodies");
    if (joint.points.size() != static_cast<std::size_t>(form.points()) ||
        joint.vectors.size() != static_cast<std::size_t>(form.vectors()))
      refuse("has " + counted(joint.points.size(), "point") + " and " +
             counted(joint.vectors.size(), "vector") + "; " + std::string(form.name) + " takes " +
             std::string(form.takes));
    check_carried(mechanism, i, form, joint.points, form.common_points, mechanism.points, points,
                  "point");
    check_carried(mechanism, i, form, joint.vectors, form.common_vectors, mechanism.vectors,
                  vectors, "vector");
    check_axis(mechanism, i, form);
    for (const int b : joint.bodies)
      if (joint.type == Mechanism::JointType::fixed && mechanism.bodies[b].own)
        refuse("fixes " + in_quotes(mechanism.bodies[b].name) +
               ", which has a frame of its own, where that is drawn, which is an estimate; "
               "give the points and vectors of both as those of one body");
  }
}

}  // namespace desmo
