#include "formulations/modelling/coordinates/placement.h"

#include <algorithm>
#include <limits>

#include "cases/mechanism/joint_forms.h"

namespace desmo {

namespace {

using Direction = Mechanism::Direction;

/// The first group that needs each point and vector, in solution order; `never`: none does.
/// - The definition of a driven or coupled coordinate needs its entities in the first group that
///   carries them.
/// - The equations of a joint belong to the later group of its two bodies, which needs what they
///   read. Joints need nothing for entities that both bodies share.
/// - A vector along two points is solved for by an equation between the three.
class FirstNeed {
 public:
  static constexpr int at_once = -1, never = std::numeric_limits<int>::max();

  FirstNeed(const Mechanism& mechanism, const RigidBodies& rigid, const Structure& structure)
      : mechanism_(mechanism),
        rigid_(rigid),
        structure_(structure),
        of_point_(mechanism.points.size(), never),
        of_vector_(mechanism.vectors.size(), never) {
    need_for_coordinates();
    for (const Mechanism::Joint& joint : mechanism.joints) need_for_joint(joint);
  }

  /// Adds the needs of vectors that follow from points. group_of_vector: the group that solves for
  /// each vector.
  void add_lines_of_vectors(const std::vector<int>& group_of_vector) {
    for (std::size_t r = 1; r < rigid_.list.size(); ++r)
      for (const int v : rigid_.list[r].vectors) {
        if (!follows_from_points(mechanism_, rigid_.list[r], v)) continue;
        const auto& [from, to] = *mechanism_.vectors[v].along;
        need({Mechanism::none, from, to}, std::max(structure_.of_body[r], group_of_vector[v]));
      }
  }

  int of_point(int point) const { return of_point_[point]; }
  int of_vector(int vector) const { return of_vector_[vector]; }

 private:
  void need_point(int point, int group) { of_point_[point] = std::min(of_point_[point], group); }
  void need_vector(int vector, int group) {
    of_vector_[vector] = std::min(of_vector_[vector], group);
  }
  void need(const Direction& direction, int group) {
    if (direction.is_line()) {
      need_point(direction.from, group);
      need_point(direction.to, group);
    } else if (direction.is_given()) {
      need_vector(direction.vector, group);
    }
  }

  void need_for_coordinates() {
    std::vector<bool> is_coupled(mechanism_.coordinates.size(), false);
    for (const Mechanism::Coupling& coupling : mechanism_.couplings)
      for (const auto& [coordinate, factor] : coupling.terms) is_coupled[coordinate] = true;
    for (std::size_t i = 0; i < mechanism_.coordinates.size(); ++i) {
      const Mechanism::Coordinate& c = mechanism_.coordinates[i];
      if (!c.driven && !is_coupled[i]) continue;
      for (const Direction* direction : {&c.of, &c.from, &c.towards}) need(*direction, at_once);
      if (c.point >= 0) need_point(c.point, at_once);
      if (c.vector >= 0) need_vector(c.vector, at_once);
    }
  }

  void need_for_joint(const Mechanism::Joint& joint) {
    const int first = rigid_.of_body[joint.bodies[0]], second = rigid_.of_body[joint.bodies[1]];
    const JointForm& form = *find_joint_form(joint.type, mechanism_.dimension);
    if (first == second || form.own_points + form.own_vectors == 0) return;
    const int group = std::max(structure_.of_body[first], structure_.of_body[second]);
    for (int i = form.common_points; i < form.points(); ++i) need_point(joint.points[i], group);
    for (const int v : joint.vectors) need_vector(v, group);
  }

  const Mechanism& mechanism_;
  const RigidBodies& rigid_;
  const Structure& structure_;
  std::vector<int> of_point_, of_vector_;
};

/// Returns the structural group that solves for a point or vector; -1: it is on the ground or on no
/// body. carriers: rigid bodies that carry it. first_need: first group that needs it. in_basis:
/// tells whether it is in a basis.
template <class InBasis>
int finder(const RigidBodies& rigid, const Structure& structure, const std::vector<int>& carriers,
           int first_need, InBasis&& in_basis) {
  if (carriers.empty() || carriers.front() == 0) return -1;
  // Groups of the carriers whose basis contains it, and groups of all other carriers.
  std::vector<int> building, following;
  for (const int r : carriers)
    (in_basis(rigid.list[r].basis) ? building : following).push_back(structure.of_body[r]);
  std::ranges::sort(building);
  std::ranges::sort(following);
  if (building.empty()) return following.front();
  if (following.empty() || building.front() <= following.front()) return building.front();
  // A body of an earlier group carries it, too. It can wait for the later group with a basis that
  // contains it. That group must be the only one, and nothing may need it before.
  const bool one_builds = building.front() == building.back();
  const bool needed_before =
      first_need < building.front() ||
      std::ranges::upper_bound(following, building.front()) - following.begin() > 1;
  return one_builds && !needed_before ? building.front() : following.front();
}

}  // namespace

int Placement::of(const Mechanism::Coordinate& c) const {
  int last = -1;
  for (const Direction* d : {&c.of, &c.from, &c.towards}) {
    if (d->is_line())
      last = std::max({last, of_point[d->from], of_point[d->to]});
    else if (d->is_given())
      last = std::max(last, of_vector[d->vector]);
  }
  if (c.vector >= 0) last = std::max(last, of_vector[c.vector]);
  if (c.point >= 0) last = std::max(last, of_point[c.point]);
  return last;
}

Placement place_entities(const Mechanism& mechanism, const RigidBodies& rigid,
                         const Structure& structure, bool may_wait) {
  FirstNeed need(mechanism, rigid, structure);
  Placement result;
  for (int v = 0; v < static_cast<int>(mechanism.vectors.size()); ++v)
    result.of_vector.push_back(finder(rigid, structure, rigid.of_vector[v],
                                      may_wait ? need.of_vector(v) : FirstNeed::at_once,
                                      [&](const Basis& b) { return b.has_vector(v); }));
  need.add_lines_of_vectors(result.of_vector);
  for (int p = 0; p < static_cast<int>(mechanism.points.size()); ++p)
    result.of_point.push_back(finder(rigid, structure, rigid.of_point[p],
                                     may_wait ? need.of_point(p) : FirstNeed::at_once,
                                     [&](const Basis& b) { return b.has_point(p); }));
  return result;
}

}  // namespace desmo
