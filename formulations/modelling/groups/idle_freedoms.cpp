#include <algorithm>

#include "formulations/modelling/groups/structure.h"

namespace desmo {

namespace {

/// Returns a name in quotes. The name stays whole; in_quotes(), for messages, cuts a long one.
std::string quoted(const std::string& name) { return "'" + name + "'"; }

std::string line_of(const Mechanism& mechanism, int a, int b) {
  return "the line of " + quoted(mechanism.points[a].name) + " and " +
         quoted(mechanism.points[b].name);
}

std::string axis(const Mechanism& mechanism, const Basis& basis) {
  const std::string& origin = mechanism.points[basis.origin].name;
  if (basis.directions.empty()) return quoted(origin);
  const Mechanism::Direction& along = basis.directions.front();
  return along.is_line() ? line_of(mechanism, along.from, along.to)
                         : "the line through " + quoted(origin) + " along " +
                               quoted(mechanism.vectors[along.vector].name);
}

}  // namespace

std::vector<IdleFreedom> find_idle_freedoms(const Mechanism& mechanism, const RigidBodies& rigid) {
  std::vector<IdleFreedom> idle;
  if (mechanism.dimension == 2) return idle;
  for (std::size_t r = 1; r < rigid.list.size(); ++r) {
    const RigidBody& body = rigid.list[r];
    if (body.basis.origin >= 0 && body.basis.directions.size() < 2)
      idle.push_back({mechanism.bodies[body.bodies.front()].name, axis(mechanism, body.basis)});
  }
  return idle;
}

std::string undetermined_spin(const Mechanism& mechanism, const RigidBodies& rigid, int body) {
  if (mechanism.dimension == 2) return {};
  std::vector<int> centres;
  for (const Mechanism::Joint& j : mechanism.joints) {
    if (!rigid.is_joint_of(body, j)) continue;
    if (j.points.size() != 1 || !j.vectors.empty()) return {};  // the joint is not spherical
    if (std::ranges::find(centres, j.points[0]) == centres.end()) centres.push_back(j.points[0]);
  }
  return centres.size() == 2 ? line_of(mechanism, centres[0], centres[1]) : std::string();
}

}  // namespace desmo
