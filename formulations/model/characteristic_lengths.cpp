#include "formulations/model/characteristic_lengths.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "formulations/model/scales.h"

namespace desmo {

bool joins_points(const Model& m, const Constraint& c) {
  return std::ranges::count(c.operands, EntityKind::point,
                            [&](EntityId e) { return m.entities[e].kind; }) > 1;
}

CharacteristicLengths::CharacteristicLengths(const Model& m)
    : m_(m),
      size_(nominal_size(m)),
      about_(m.entities.size()),
      of_group_(m.groups.size()),
      shortest_(m.entities.size()) {
  for (const Constraint& c : m.constraints) {
    const double length = extent(c);
    for (const EntityId e : c.operands) {
      about_[e] = std::max(about_[e], length);
      if (length > 0) shortest_[e] = shortest_[e] > 0 ? std::min(shortest_[e], length) : length;
    }
    of_group_[c.group] = std::max(of_group_[c.group], length);
    of_all_ = std::max(of_all_, length);
  }
}

/// Returns the largest distance between points of a constraint, or the largest of its distance
/// operands. Where the constraint does not join points, a distance operand counts as the size of
/// the mechanism at most: a larger one tells where the origin is.
double CharacteristicLengths::extent(const Constraint& c) const {
  const double limit = joins_points(m_, c) ? INFINITY : size_;
  double largest = 0;
  const auto at_least = [&](double length) {
    if (length > largest && std::isfinite(length)) largest = length;
  };
  const auto position = [&](EntityId e) {
    return (m_.entities[e].fixed ? m_.fixed_values : m_.estimate).data() + m_.entities[e].first;
  };
  for (auto at = c.operands.begin(); at != c.operands.end(); ++at) {
    const EntityId a = *at;
    const double* x = position(a);
    if (m_.entities[a].kind == EntityKind::distance) at_least(std::min(std::abs(*x), limit));
    if (m_.entities[a].kind != EntityKind::point) continue;
    for (const EntityId b : std::span(at + 1, c.operands.end())) {
      if (m_.entities[b].kind != EntityKind::point) continue;
      const double* y = position(b);
      double distance = 0;
      for (int i = 0; i < m_.entities[a].size; ++i) distance = std::hypot(distance, y[i] - x[i]);
      at_least(distance);
    }
  }
  return largest;
}

double CharacteristicLengths::or_wider(double length, GroupId group) const {
  if (length > 0) return length;
  if (group >= 0 && of_group_[group] > 0) return of_group_[group];
  return of_all_ > 0 ? of_all_ : 1;
}

double CharacteristicLengths::of(EntityId e) const {
  return or_wider(about_[e], m_.entities[e].group);
}

double CharacteristicLengths::shortest(EntityId e) const {
  return or_wider(shortest_[e], m_.entities[e].group);
}

std::vector<double> CharacteristicLengths::of_coordinates() const {
  std::vector<double> result(m_.coordinates(), 1);
  for (EntityId e = 0; e < static_cast<EntityId>(m_.entities.size()); ++e)
    if (const Entity& entity = m_.entities[e]; !entity.fixed && is_length(entity.kind))
      std::fill_n(result.begin() + entity.first, entity.size, of(e));
  return result;
}

double CharacteristicLengths::of(const Constraint& c) const {
  double longest = 0;
  for (const EntityId e : c.operands)
    if (is_length(m_.entities[e].kind)) longest = std::max(longest, about_[e]);
  return or_wider(longest, c.group);
}

double CharacteristicLengths::own(const Constraint& c) const {
  const double length = c.constants.empty() ? 0 : extent(c);
  return length > 0 ? length : of(c);
}

}  // namespace desmo
