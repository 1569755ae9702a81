#include "bench/cli/view/transmission.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

namespace desmo::cli {
namespace {

struct Hinge {
  int other, point;  // body at the other end
};

/// The revolute joints of each body.
std::vector<std::vector<Hinge>> hinges_of(const Mechanism& m) {
  std::vector<std::vector<Hinge>> hinges(m.bodies.size());
  for (const Mechanism::Joint& joint : m.joints) {
    if (joint.type != Mechanism::JointType::revolute) continue;
    const auto [a, b] = joint.bodies;
    hinges[a].push_back({b, joint.points[0]});
    hinges[b].push_back({a, joint.points[0]});
  }
  return hinges;
}

/// The bodies that carry both ends of a segment whose angle is driven.
std::set<int> driven_bodies(const Mechanism& m) {
  std::set<int> driven;
  for (const Mechanism::Coordinate& c : m.coordinates) {
    if (!c.driven || c.type != Mechanism::CoordinateType::angle || !c.of.is_segment()) continue;
    for (std::size_t body = 1; body < m.bodies.size(); ++body) {
      const std::vector<int>& points = m.bodies[body].points;
      const auto has = [&](int point) { return std::ranges::count(points, point) > 0; };
      if (has(c.of.from) && has(c.of.to)) driven.insert(static_cast<int>(body));
    }
  }
  return driven;
}

std::array<double, 2> position(int point, const Mechanism& mechanism, const Model& m,
                               std::span<const double> q) {
  const Entity& e = m.entities[m.find(mechanism.points[point].name)];
  const double* const x = e.fixed ? m.fixed_values.data() + e.first : q.data() + e.first;
  return {x[0], x[1]};
}

}  // namespace

std::vector<FourBarLoop> four_bar_loops(const Mechanism& m, std::span<const GroupId> group) {
  std::vector<FourBarLoop> loops;
  if (m.dimension != 2) return loops;
  const std::vector<std::vector<Hinge>> hinges = hinges_of(m);
  const std::set<int> driven = driven_bodies(m);
  const auto is_input = [&](int input, int coupler, int follower) {
    return driven.contains(input) ||
           (!driven.contains(follower) && group[input] < std::min(group[coupler], group[follower]));
  };
  for (const Hinge& first : hinges[0])
    for (const Hinge& second : hinges[first.other])
      for (const Hinge& third : hinges[second.other])
        for (const Hinge& fourth : hinges[third.other]) {
          const int input = first.other, coupler = second.other, follower = third.other;
          if (fourth.other != 0 || input == 0 || coupler == 0 || follower == 0 ||
              input == follower || input == coupler || coupler == follower)
            continue;
          if (is_input(input, coupler, follower))
            loops.push_back({m.bodies[input].name, m.bodies[coupler].name, m.bodies[follower].name,
                             second.point, third.point, fourth.point});
        }
  return loops;
}

double transmission_angle(const FourBarLoop& loop, const Mechanism& mechanism, const Model& model,
                          std::span<const double> q) {
  const auto b = position(loop.b, mechanism, model, q), c = position(loop.c, mechanism, model, q),
             d = position(loop.d, mechanism, model, q);
  const double ux = b[0] - c[0], uy = b[1] - c[1], vx = d[0] - c[0], vy = d[1] - c[1];
  const double angle = std::atan2(std::abs(ux * vy - uy * vx), std::abs(ux * vx + uy * vy));
  return angle * 180 / std::numbers::pi;
}

}  // namespace desmo::cli
