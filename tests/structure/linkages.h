#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "formulations/modelling/modelling.h"
#include "tests/describing.h"

namespace desmo {

inline Model model(const Mechanism& d) {
  const auto drivers = std::ranges::count(d.coordinates, true, &Mechanism::Coordinate::driven);
  return model_mechanism(d, std::vector<Motion>(drivers, still)).model;
}

/// A link by its name and those of its pins.
using PinnedLink = std::pair<std::string, std::vector<std::string>>;
/// The line of two pins.
using PinLine = std::pair<std::string, std::string>;

/// Returns a planar linkage of pinned links, the angles of these lines driven.
inline Mechanism linkage(const std::string& name, const std::map<std::string, Vec>& pins,
                         const PinnedLink& ground, const std::vector<PinnedLink>& links,
                         const std::vector<PinLine>& driven) {
  Sketch d(name, 2);
  std::map<std::string, int> points;
  for (const auto& [pin, at] : pins) points[pin] = d.point(pin, at);
  const auto points_of = [&](const PinnedLink& link) {
    std::vector<int> result;
    for (const std::string& pin : link.second) result.push_back(points.at(pin));
    return result;
  };
  d.carry(Sketch::ground, points_of(ground));
  for (const PinnedLink& link : links) d.body(link.first, points_of(link));
  for (const auto& [a, b] : driven)
    d.angle("angle of " + a + b, line(points.at(a), points.at(b))).driven = true;
  return d.release_pinned();
}

/// Returns Watt's six-bar: the four-bar A0 A B B0 with the dyad link5, link6 on coupler and rocker.
inline Mechanism watt(const PinLine& driven) {
  return linkage("watt",
                 {{"A0", {0, 0, 0}},
                  {"B0", {4, 0, 0}},
                  {"A", {0.6, 0.8, 0}},
                  {"B", {3.6, 2.8, 0}},
                  {"C", {2.5, 4.5, 0}},
                  {"D", {6, 3, 0}},
                  {"E", {5.5, 6, 0}}},
                 {"ground", {"A0", "B0"}},
                 {{"crank", {"A0", "A"}},
                  {"coupler", {"A", "B", "C"}},
                  {"rocker", {"B0", "B", "D"}},
                  {"link5", {"C", "E"}},
                  {"link6", {"D", "E"}}},
                 {driven});
}

/// Returns Stephenson's third six-bar: the four-bar A0 A B B0 with a dyad from coupler to ground.
inline Mechanism stephenson(const PinLine& driven) {
  return linkage("stephenson",
                 {{"A0", {0, 0, 0}},
                  {"B0", {4, 0, 0}},
                  {"A", {0.6, 0.8, 0}},
                  {"B", {3.6, 2.8, 0}},
                  {"C", {2.5, 4.5, 0}},
                  {"E", {5.5, 6, 0}},
                  {"E0", {8, 1, 0}}},
                 {"ground", {"A0", "B0", "E0"}},
                 {{"crank", {"A0", "A"}},
                  {"coupler", {"A", "B", "C"}},
                  {"rocker", {"B0", "B"}},
                  {"link5", {"C", "E"}},
                  {"link6", {"E0", "E"}}},
                 {driven});
}

/// Returns a Stewart platform without drivers; each leg is a cylinder and a piston.
inline Sketch stewart() {
  Sketch d("stewart", 3);
  std::vector<int> feet, heads, platform_points;
  for (int i = 0; i < 6; ++i) {
    const std::string n = std::to_string(i + 1);
    feet.push_back(d.ground_point("G" + n, polar(2, i * 1.05 + (i % 2 ? 0.35 : 0))));
    heads.push_back(d.point("H" + n, polar(1, i * 1.05 + (i % 2 ? -0.2 : 0.3)) + Vec{0, 0, 2}));
  }
  const int platform = d.body("platform", heads);
  for (int i = 0; i < 6; ++i) {
    const std::string n = std::to_string(i + 1);
    const Vec a = polar(2, i * 1.05 + (i % 2 ? 0.35 : 0)),
              b = polar(1, i * 1.05 + (i % 2 ? -0.2 : 0.3)) + Vec{0, 0, 2};
    const Vec axis = unit(b - a), across = unit(cross(axis, {1, 0.1, 0}));
    const int g = d.ground_vector("g" + n, unit(cross(across, {0, 0, 1})));
    const int e = d.vector("e" + n, axis), u = d.vector("u" + n, across);
    const int cylinder = d.body("cylinder" + n, {feet[i]}, {e, u}),
              piston = d.body("piston" + n, {heads[i]}, {e, u});
    d.joint(JointType::universal, Sketch::ground, cylinder, {feet[i]}, {g, u});
    d.joint(JointType::prismatic, cylinder, piston, {feet[i], heads[i]}, {e, u});
    d.joint(JointType::spherical, piston, platform, {heads[i]});
    d.along("s" + n, feet[i], heads[i], e);
  }
  return d;
}

}  // namespace desmo
