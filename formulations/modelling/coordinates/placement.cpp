#include "formulations/modelling/coordinates/placement.h"

#include <algorithm>

namespace desmo {

namespace {

using Direction = Mechanism::Direction;

/// Whether each point and vector defines a driven or coupled coordinate. Then the first group that
/// carries it needs it.
struct NeededAtOnce {
  explicit NeededAtOnce(const Mechanism& mechanism)
      : points(mechanism.points.size(), false), vectors(mechanism.vectors.size(), false) {
    std::vector<bool> is_coupled(mechanism.coordinates.size(), false);
    for (const Mechanism::Coupling& coupling : mechanism.couplings)
      for (const auto& [coordinate, factor] : coupling.terms) is_coupled[coordinate] = true;
    for (std::size_t i = 0; i < mechanism.coordinates.size(); ++i) {
      const Mechanism::Coordinate& c = mechanism.coordinates[i];
      if (!c.driven && !is_coupled[i]) continue;
      for (const Direction* direction : {&c.of, &c.from, &c.towards}) {
        if (direction->is_line())
          points[direction->from] = points[direction->to] = true;
        else if (direction->is_given())
          vectors[direction->vector] = true;
      }
      if (c.point >= 0) points[c.point] = true;
      if (c.vector >= 0) vectors[c.vector] = true;
    }
  }
  std::vector<bool> points, vectors;
};

/// Returns the structural group that solves for a point or vector; -1: it is on the ground or on no
/// body. carriers: rigid bodies that carry it. in_basis: tells whether it is in a basis.
template <class InBasis>
int finder(const RigidBodies& rigid, const Structure& structure, const std::vector<int>& carriers,
           bool needed_at_once, InBasis&& in_basis) {
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
      needed_at_once ||
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
  const NeededAtOnce needed(mechanism);
  Placement result;
  for (int p = 0; p < static_cast<int>(mechanism.points.size()); ++p)
    result.of_point.push_back(finder(rigid, structure, rigid.of_point[p],
                                     !may_wait || needed.points[p],
                                     [&](const Basis& b) { return b.has_point(p); }));
  for (int v = 0; v < static_cast<int>(mechanism.vectors.size()); ++v)
    result.of_vector.push_back(finder(rigid, structure, rigid.of_vector[v],
                                      !may_wait || needed.vectors[v],
                                      [&](const Basis& b) { return b.has_vector(v); }));
  return result;
}

}  // namespace desmo
