#include <algorithm>
#include <iterator>
#include <set>
#include <stdexcept>

#include "cases/mechanism/joint_forms.h"
#include "formulations/modelling/groups/structure.h"

namespace desmo {

std::vector<Restriction> find_restrictions(const Mechanism& mechanism, const RigidBodies& rigid) {
  std::vector<Restriction> all;
  for (const Mechanism::Joint& j : mechanism.joints) {
    Restriction r{{}, find_joint_form(j.type, mechanism.dimension)->freedoms_removed};
    for (const int b : j.bodies)
      if (rigid.of_body[b] != 0) r.bodies.push_back(rigid.of_body[b]);
    std::ranges::sort(r.bodies);
    const bool one_body = rigid.of_body[j.bodies[0]] == rigid.of_body[j.bodies[1]];
    if (!one_body) all.push_back(std::move(r));
  }
  for (const Mechanism::Coordinate& c : mechanism.coordinates) {
    if (!c.driven) continue;
    all.push_back({bodies_related(rigid, c), 1});
    if (all.back().bodies.empty())
      throw std::invalid_argument("driver '" + c.name +
                                  "' measures nothing that can move; drive another coordinate");
  }
  for (const Mechanism::Coupling& coupling : mechanism.couplings) {
    std::set<int> bodies;
    for (const auto& [coordinate, factor] : coupling.terms)
      for (const int b : bodies_related(rigid, mechanism.coordinates[coordinate])) bodies.insert(b);
    if (bodies.empty())
      throw std::invalid_argument("coupling '" + coupling.name + "' relates nothing that can move");
    all.push_back({{bodies.begin(), bodies.end()}, 1});
  }
  return all;
}

std::vector<int> bodies_related(const RigidBodies& rigid, const Mechanism::Coordinate& c) {
  std::set<int> result;
  const auto add = [&](const std::vector<int>& carriers) {
    if (!carriers.empty() && carriers.front() != 0) result.insert(carriers.front());
  };
  const auto add_direction = [&](const Mechanism::Direction& direction) {
    if (!direction.is_given()) return;
    if (!direction.is_line()) return add(rigid.of_vector[direction.vector]);
    const std::vector<int>&a = rigid.of_point[direction.from], &b = rigid.of_point[direction.to];
    std::vector<int> both;
    std::ranges::set_intersection(a, b, std::back_inserter(both));
    if (!both.empty()) return add(both);
    add(a);
    add(b);
  };
  if (c.type == Mechanism::CoordinateType::along) {
    // Takes the first body that carries the point and the vector; where none carries both, the
    // first that carries the point.
    for (const int point : {c.of.from, c.of.to}) {
      std::vector<int> both;
      std::ranges::set_intersection(rigid.of_point[point], rigid.of_vector[c.vector],
                                    std::back_inserter(both));
      add(both.empty() ? rigid.of_point[point] : both);
    }
  } else {
    add_direction(c.of);
  }
  add_direction(c.from);
  add_direction(c.towards);
  if (c.point >= 0) add(rigid.of_point[c.point]);
  return {result.begin(), result.end()};
}

}  // namespace desmo
