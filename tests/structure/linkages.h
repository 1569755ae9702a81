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

/// A builder of planar linkages of pinned links, given by the names of their pins.
class Linkage {
 public:
  explicit Linkage(std::string name, std::map<std::string, Vec> pins) : d_(std::move(name), 2) {
    for (const auto& [pin, at] : pins) point_[pin] = d_.point(pin, at);
  }

  /// Adds a link and joins it at each pin to the body added there before, if any.
  void link(const std::string& body, const std::vector<std::string>& pins) {
    std::vector<int> points;
    for (const std::string& p : pins) points.push_back(point_.at(p));
    const int b = d_.body(body, points);
    body_[body] = b;
    for (const std::string& p : pins) join(p, b);
  }
  void ground(const std::vector<std::string>& pins) {
    for (const std::string& p : pins) {
      d_.carry(Sketch::ground, {point_.at(p)});
      join(p, Sketch::ground);
    }
  }
  void drive(const std::string& a, const std::string& b) {
    d_.angle("angle of " + a + b, line(point_.at(a), point_.at(b))).driven = true;
  }
  Sketch& sketch() { return d_; }
  int point(const std::string& pin) const { return point_.at(pin); }
  int body(const std::string& name) const { return body_.at(name); }
  Mechanism release() { return d_.release(); }

 private:
  void join(const std::string& pin, int body) {
    if (const auto it = last_.find(pin); it != last_.end())
      d_.revolute(it->second, body, point_.at(pin));
    last_[pin] = body;
  }

  Sketch d_;
  std::map<std::string, int> point_, body_, last_;
};

/// Returns Watt's six-bar: the four-bar A0 A B B0 with the dyad link5, link6 on coupler and rocker.
inline Linkage watt() {
  Linkage l("watt", {{"A0", {0, 0, 0}},
                     {"B0", {4, 0, 0}},
                     {"A", {0.6, 0.8, 0}},
                     {"B", {3.6, 2.8, 0}},
                     {"C", {2.5, 4.5, 0}},
                     {"D", {6, 3, 0}},
                     {"E", {5.5, 6, 0}}});
  l.ground({"A0", "B0"});
  l.link("crank", {"A0", "A"});
  l.link("coupler", {"A", "B", "C"});
  l.link("rocker", {"B0", "B", "D"});
  l.link("link5", {"C", "E"});
  l.link("link6", {"D", "E"});
  return l;
}

/// Returns Stephenson's third six-bar: the four-bar A0 A B B0 with a dyad from coupler to ground.
inline Linkage stephenson() {
  Linkage l("stephenson", {{"A0", {0, 0, 0}},
                           {"B0", {4, 0, 0}},
                           {"A", {0.6, 0.8, 0}},
                           {"B", {3.6, 2.8, 0}},
                           {"C", {2.5, 4.5, 0}},
                           {"E", {5.5, 6, 0}},
                           {"E0", {8, 1, 0}}});
  l.ground({"A0", "B0", "E0"});
  l.link("crank", {"A0", "A"});
  l.link("coupler", {"A", "B", "C"});
  l.link("rocker", {"B0", "B"});
  l.link("link5", {"C", "E"});
  l.link("link6", {"E0", "E"});
  return l;
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
