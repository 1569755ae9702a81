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
    points_[name] = {b_.point(name, at), at};
  }
  void ground(const std::vector<std::string>& names) {
    for (const std::string& n : names) carry(MechanismBuilder::ground, n);
  }
  /// Adds a body "AB" with the points a and b, a link of constant length. Returns its position
  /// among the bodies. Without a length it has the nominal one.
  int link(const std::string& a, const std::string& b) {
    return link(a, b, length_between(points_[a].at, points_[b].at));
  }
  int link(const std::string& a, const std::string& b, double length) {
    const int body = b_.link(a + b, index(a), index(b), length);
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
    b_.carry(body, {index(name)});
    pin(body, name);
  }
  /// Lets a point of a body slide on a line of the ground: through the point `on`, along `vector`.
  /// The body turns freely about the point.
  void slide(const std::string& point, int body, const std::string& on, int vector) {
    b_.joint(Mechanism::JointType::revolute_on_slider, MechanismBuilder::ground, body,
             {index(on), index(point)}, {vector});
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
    return b_.angle(name, {-1, index(a), index(b)});
  }
  /// Drives the angle of the line from a to b.
  void drive_angle(const std::string& a, const std::string& b) {
    angle("theta", a, b).driven = true;
  }
  /// Drives the distance from a to b along a vector.
  void drive_along(const std::string& a, const std::string& b, int vector) {
    b_.along("s", index(a), index(b), vector).driven = true;
  }
  /// Returns the position of a point in the mechanism.
  int index(const std::string& name) { return points_[name].index; }
  MechanismBuilder& builder() { return b_; }
  /// Returns the mechanism; the builder is then empty.
  Mechanism release() { return b_.release(); }

 private:
  void pin(int body, const std::string& name) {
    Point& point = points_[name];
    const int before = std::exchange(point.last_body, body);
    if (before >= 0) b_.joint(Mechanism::JointType::revolute, before, body, {point.index});
  }

  struct Point {
    int index;
    Mechanism::Vec at;
    int last_body = -1;  // the last body with the point so far; -1: none
  };
  MechanismBuilder b_;
  std::map<std::string, Point> points_;
};

}  // namespace desmo::properties
