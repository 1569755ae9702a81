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

const JointForm& form_of(const Mechanism& d, int i) {
  const Mechanism::Joint& joint = d.joints[i];
  if (const JointForm* form = find_joint_form(joint.type, d.dimension)) return *form;
  const JointForm* elsewhere = find_joint_form(joint.type, 5 - d.dimension);
  if (!elsewhere) refuse(d, Part::joint, i, "has a type that does not exist");
  refuse(d, Part::joint, i,
         std::string(elsewhere->name) + " joints exist only " +
             (d.dimension == 2 ? "in space, this mechanism is plane"
                               : "in the plane, this mechanism is spatial") +
             "; choose another type");
}

// Checks one list of a joint, its points or its vectors. Both bodies must carry each common entity.
// Of the own ones, the first body must carry the first, and the second body the second.
template <class Entry>
void check_carried(const Mechanism& d, int i, const JointForm& form, const std::vector<int>& joined,
                   int common, const std::vector<Entry>& entries, const Carriers& carriers,
                   const char* kind) {
  const Mechanism::Joint& joint = d.joints[i];
  for (int k = 0; k < static_cast<int>(joined.size()); ++k) {
    if (!is_in(joined[k], entries))
      refuse(d, Part::joint, i, std::string("joins a ") + kind + " that does not exist");
    if (k > 0 && joined[k] == joined[0])
      refuse(d, Part::joint, i,
             std::string("lists the ") + kind + " " + in_quotes(entries[joined[k]].name) +
                 " twice; name two different ones");
    for (int side = 0; side < 2; ++side) {
      if (k >= common && side != k - common) continue;
      if (carriers.carries(joint.bodies[side], joined[k])) continue;
      refuse(d, Part::joint, i,
             std::string("the ") + kind + " " + in_quotes(entries[joined[k]].name) +
                 " is not carried by " + in_quotes(d.bodies[joint.bodies[side]].name) + "; " +
                 std::string(form.name) + " takes " + std::string(form.takes));
    }
  }
}

// Checks that two common points (hinge) differ, so that they determine the axis. Checks that two
// common vectors (prismatic in space) are not parallel, so that they prevent rotation.
void check_axis(const Mechanism& d, int i, const JointForm& form) {
  if (form.common_points == 2) {
    const Mechanism::Point &p = d.points[d.joints[i].points[0]],
                           &q = d.points[d.joints[i].points[1]];
    if (!direction(p.position, q.position))
      refuse(d, Part::joint, i,
             "its points " + in_quotes(p.name) + " and " + in_quotes(q.name) +
                 " coincide; the axis goes through two different places");
  }
  if (form.common_vectors < 2) return;
  const std::vector<int>& vectors = d.joints[i].vectors;
  if (!common_normal(d.vectors[vectors[0]].direction, d.vectors[vectors[1]].direction))
    refuse(d, Part::joint, i,
           "its vectors " + in_quotes(d.vectors[vectors[0]].name) + " and " +
               in_quotes(d.vectors[vectors[1]].name) +
               " are parallel; the second must cross the axis");
}

}  // namespace

void check_joints(const Mechanism& d, const Carriers& points, const Carriers& vectors) {
  for (int i = 0; i < static_cast<int>(d.joints.size()); ++i) {
    const Mechanism::Joint& joint = d.joints[i];
    const JointForm& form = form_of(d, i);
    if (!is_in(joint.bodies[0], d.bodies) || !is_in(joint.bodies[1], d.bodies))
      refuse(d, Part::joint, i, "joins a body that does not exist");
    if (joint.bodies[0] == joint.bodies[1])
      refuse(d, Part::joint, i,
             "joins " + in_quotes(d.bodies[joint.bodies[0]].name) +
                 " with itself; name two different bodies");
    if (joint.points.size() != static_cast<std::size_t>(form.points()) ||
        joint.vectors.size() != static_cast<std::size_t>(form.vectors()))
      refuse(d, Part::joint, i,
             "has " + counted(joint.points.size(), "point") + " and " +
                 counted(joint.vectors.size(), "vector") + "; " + std::string(form.name) +
                 " takes " + std::string(form.takes));
    check_carried(d, i, form, joint.points, form.common_points, d.points, points, "point");
    check_carried(d, i, form, joint.vectors, form.common_vectors, d.vectors, vectors, "vector");
    check_axis(d, i, form);
    for (const int b : joint.bodies)
      if (joint.type == Mechanism::JointType::fixed && d.bodies[b].own)
        refuse(d, Part::joint, i,
               "fixes " + in_quotes(d.bodies[b].name) +
                   ", which has a frame of its own, where that is drawn, which is an estimate; "
                   "give the points and vectors of both as those of one body");
  }
}

}  // namespace desmo
