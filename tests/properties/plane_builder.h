#pragma once

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "cases/generators/dyad_chain.h"
#include "cases/mechanism/builder.h"

namespace desmo::properties {

inline double length_between(const Mechanism::Vec& a, const Mechanism::Vec& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

inline Mechanism::Vec polar(const Mechanism::Vec& from, double length, double angle) {
  return {from[0] + length * std::cos(angle), from[1] + length * std::sin(angle), 0};
}

/// Returns where circles about two points meet, left of the line between them for side 1.
inline Mechanism::Vec meeting(const Mechanism::Vec& a, double from_a, const Mechanism::Vec& b,
                              double from_b, int side) {
  return closed_dyad(a, b, from_a, from_b, side).joint;
}

/// A builder of planar mechanisms in which points have names. All bodies with the same point are
/// pinned to each other there.
class PlaneBuilder {
 public:
  /// points: names and nominal positions. on_ground: names of points that rest.
  explicit PlaneBuilder(std::string name,
                        const std::vector<std::pair<std::string, Mechanism::Vec>>& points = {},
                        const std::vector<std::string>& on_ground = {})
      : b_(std::move(name), 2) {
    b_.set_length_unit("1");
    for (const auto& [point_name, at] : points) point(point_name, at);
    ground(on_ground);
  }

  void point(const std::string& name, const Mechanism::Vec& at) {
    points_[name] = b_.point(name, at);
    at_[name] = at;
  }
  void ground(const std::vector<std::string>& names) {
    for (const std::string& n : names) carry(MechanismBuilder::ground, n);
  }
  /// Adds a body "AB" with the points a and b, a link of constant length. Returns its position
  /// among the bodies. Without a length it has the nominal one.
  int link(const std::string& a, const std::string& b) {
    return link(a, b, length_between(at_[a], at_[b]));
  }
  int link(const std::string& a, const std::string& b, double length) {
    const int body = b_.link(a + b, points_[a], points_[b], length);
    pin(body, a);
    pin(body, b);
    return body;
  }
  /// Adds a rigid body with these points. Returns its position among the bodies.
  int body(const std::string& name, const std::vector<std::string>& names) {
    const int body = b_.body(name, {});
    for (const std::string& n : names) carry(body, n);
    return body;
  }
  /// Fixes a point to a body.
  void carry(int body, const std::string& name) {
    b_.carry(body, {points_[name]});
    pin(body, name);
  }
  /// Lets a point of a body slide on a line of the ground: through the point `on`, along `vector`.
  /// The body turns freely about the point.
  void slide(const std::string& point, int body, const std::string& on, int vector) {
    b_.joint(Mechanism::JointType::revolute_on_slider, MechanismBuilder::ground, body,
             {points_[on], points_[point]}, {vector});
  }
  /// Adds a direction of the ground. Returns its position among the vectors.
  int ground_vector(const std::string& name, const Mechanism::Vec& direction) {
    const int v = b_.vector(name, direction);
    b_.carry(MechanismBuilder::ground, {}, {v});
    return v;
  }
  /// Adds the angle of the line from a to b.
  Mechanism::Coordinate& angle(const std::string& name, const std::string& a,
                               const std::string& b) {
    return b_.angle(name, {-1, points_[a], points_[b]});
  }
  /// Drives the angle of the line from a to b.
  void drive_angle(const std::string& a, const std::string& b) {
    angle("theta", a, b).driven = true;
  }
  /// Drives the distance from a to b along a vector.
  void drive_along(const std::string& a, const std::string& b, int vector) {
    b_.along("s", points_[a], points_[b], vector).driven = true;
  }
  /// Returns the position of a point in the mechanism.
  int index(const std::string& name) { return points_[name]; }
  MechanismBuilder& builder() { return b_; }
  /// Returns the mechanism, its joints with distinct names; the builder is then empty.
  Mechanism release() {
    Mechanism m = b_.release();
    for (std::size_t i = 0; i < m.joints.size(); ++i) m.joints[i].name += "/" + std::to_string(i);
    return m;
  }

 private:
  void pin(int body, const std::string& name) {
    const auto [it, is_new] = last_.try_emplace(name, body);
    if (is_new) return;
    b_.joint(Mechanism::JointType::revolute, it->second, body, {points_[name]});
    it->second = body;
  }

  MechanismBuilder b_;
  std::map<std::string, int> points_, last_;  // last body with the point
  std::map<std::string, Mechanism::Vec> at_;
};

}  // namespace desmo::properties
