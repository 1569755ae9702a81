#include "formulations/modelling/coordinates/placement.h"

#include <algorithm>
#include <limits>

#include "cases/mechanism/joint_forms.h"

namespace desmo {

namespace {

constexpr int at_once = -1, never = std::numeric_limits<int>::max();

/// The first group that needs each point and vector, in solution order; `never`: none does.
struct FirstNeed {
  std::vector<int> of_point, of_vector;

  void need_point(int p, int group) { of_point[p] = std::min(of_point[p], group); }
  void need_vector(int v, int group) { of_vector[v] = std::min(of_vector[v], group); }
};

/// Calls on_point(p) and on_vector(v) for all points and vectors in the definition of a coordinate.
template <class OnPoint, class OnVector>
void visit_entities(const Mechanism::Coordinate& c, OnPoint&& on_point, OnVector&& on_vector) {
  for (const Mechanism::Direction* d : {&c.of, &c.from, &c.towards}) {
    if (d->is_line()) {
      on_point(d->from);
      on_point(d->to);
    } else if (d->is_given()) {
      on_vector(d->vector);
    }
  }
  if (c.point >= 0) on_point(c.point);
  if (c.vector >= 0) on_vector(c.vector);
}

/// Returns the needs of coordinates and joints:
/// - The definition of a driven or coupled coordinate needs its entities in the first group that
///   carries them.
/// - The equations of a joint belong to the later group of its two bodies, which needs what they
///   read. Joints need nothing for entities that both bodies share.
FirstNeed first_needs(const Mechanism& mechanism, const RigidBodies& rigid,
                      const Structure& structure) {
  FirstNeed needs{std::vector<int>(mechanism.points.size(), never),
                  std::vector<int>(mechanism.vectors.size(), never)};
  std::vector<bool> is_coupled(mechanism.coordinates.size(), false);
  for (const Mechanism::Coupling& coupling : mechanism.couplings)
    for (const auto& [coordinate, factor] : coupling.terms) is_coupled[coordinate] = true;
  for (std::size_t c = 0; c < is_coupled.size(); ++c)
    if (mechanism.coordinates[c].driven || is_coupled[c])
      visit_entities(
          mechanism.coordinates[c], [&](int p) { needs.need_point(p, at_once); },
          [&](int v) { needs.need_vector(v, at_once); });
  for (const Mechanism::Joint& joint : mechanism.joints) {
    const int first = rigid.of_body[joint.bodies[0]], second = rigid.of_body[joint.bodies[1]];
    const JointForm& form = *find_joint_form(joint.type, mechanism.dimension);
    if (first == second || form.own_points + form.own_vectors == 0) continue;
    const int group = std::max(structure.of_body[first], structure.of_body[second]);
    for (int i = form.common_points; i < form.points(); ++i)
      needs.need_point(joint.points[i], group);
    for (const int v : joint.vectors) needs.need_vector(v, group);
  }
  return needs;
}

/// Returns the structural group that solves for a point or vector; -1: it is on the ground or on no
/// body. carriers: rigid bodies that carry it. first_need: first group that needs it. in_basis:
/// tells whether it is in a basis.
template <class InBasis>
int finder(const RigidBodies& rigid, const Structure& structure, const std::vector<int>& carriers,
           int first_need, InBasis&& in_basis) {
  if (carriers.empty() || carriers.front() == 0) return -1;
  int first = never;
  // Groups of the carriers whose basis contains it, and groups of all other carriers.
  std::vector<int> building, following;
  for (const int r : carriers) {
    const int group = structure.of_body[r];
    first = std::min(first, group);
    (in_basis(rigid.list[r].basis) ? building : following).push_back(group);
  }
  if (building.empty()) return first;
  // It can wait for the one group with a basis that contains it, if nothing needs it before and at
  // most one body follows from it until then.
  const int next = std::ranges::min(building), last = std::ranges::max(building);
  const auto followers = std::ranges::count_if(following, [&](int g) { return g <= next; });
  return next == last && first_need >= next && followers <= 1 ? next : first;
}

}  // namespace

int Placement::of(const Mechanism::Coordinate& c) const {
  int last = -1;
  visit_entities(
      c, [&](int p) { last = std::max(last, of_point[p]); },
      [&](int v) { last = std::max(last, of_vector[v]); });
  return last;
}

Placement place_entities(const Mechanism& mechanism, const RigidBodies& rigid,
                         const Structure& structure, bool may_wait) {
  FirstNeed needs = may_wait ? first_needs(mechanism, rigid, structure)
                             : FirstNeed{std::vector<int>(mechanism.points.size(), at_once),
                                         std::vector<int>(mechanism.vectors.size(), at_once)};
  Placement result;
  for (int v = 0; v < static_cast<int>(mechanism.vectors.size()); ++v)
    result.of_vector.push_back(finder(rigid, structure, rigid.of_vector[v], needs.of_vector[v],
                                      [&](const Basis& b) { return b.has_vector(v); }));
  // A vector along two points is solved for by an equation between the three.
  for (std::size_t r = 1; r < rigid.list.size(); ++r)
    for (const int v : rigid.list[r].vectors) {
      if (!follows_from_points(mechanism, rigid.list[r], v)) continue;
      const int group = std::max(structure.of_body[r], result.of_vector[v]);
      for (const int p : *mechanism.vectors[v].along) needs.need_point(p, group);
    }
  for (int p = 0; p < static_cast<int>(mechanism.points.size()); ++p)
    result.of_point.push_back(finder(rigid, structure, rigid.of_point[p], needs.of_point[p],
                                     [&](const Basis& b) { return b.has_point(p); }));
  return result;
}

}  // namespace desmo
