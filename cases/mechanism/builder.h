#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cases/mechanism/mechanism.h"

namespace desmo {

/// Builder of a mechanism, step by step. Functions that add a point, a vector or a body return its
/// index in the mechanism's list, by which later calls refer to it. No function checks anything:
/// validate() and make_model() do. Lengths are in metres (or the free unit), angles in radians.
///
///   MechanismBuilder builder("crank", 2);
///   const int a = builder.point("A", {0, 0}), b = builder.point("B", {0.05, 0});
///   const int crank = builder.body("crank", {a, b});
///   builder.carry(MechanismBuilder::ground, {a});
///   builder.joint(Mechanism::JointType::revolute, MechanismBuilder::ground, crank, {a});
///   builder.angle("angle", {.from = a, .to = b}).driven = true;
///   const Mechanism mechanism = builder.release();
class MechanismBuilder {
 public:
  /// Begins with the ground alone. dimension: 2 or 3.
  explicit MechanismBuilder(std::string name, int dimension) {
    mechanism_.name = std::move(name);
    mechanism_.dimension = dimension;
    mechanism_.bodies.push_back({"ground"});
  }

  static constexpr int ground = 0;  ///< index of the ground among the bodies

  /// Sets Mechanism::length_unit: "m" (the default) or "1".
  void set_length_unit(std::string unit) { mechanism_.length_unit = std::move(unit); }

  /// Adds a point at its nominal position. A body carries it once body() or carry() says so.
  int point(std::string name, const Mechanism::Vec& position) {
    mechanism_.points.push_back({std::move(name), position});
    return static_cast<int>(mechanism_.points.size()) - 1;
  }
  /// Adds a vector with its nominal direction, of length 1.
  int vector(std::string name, const Mechanism::Vec& direction) {
    mechanism_.vectors.push_back({std::move(name), direction});
    return static_cast<int>(mechanism_.vectors.size()) - 1;
  }
  /// Adds a vector that always points from one point to another. A body that carries the vector
  /// must carry both points.
  int vector_along(std::string name, const Mechanism::Vec& direction, int from, int to) {
    const int v = vector(std::move(name), direction);
    mechanism_.vectors[v].along = {from, to};
    return v;
  }
  /// Adds a body that carries these points and vectors.
  int body(std::string name, std::vector<int> points, std::vector<int> vectors = {}) {
    mechanism_.bodies.push_back({std::move(name), std::move(points), std::move(vectors)});
    return static_cast<int>(mechanism_.bodies.size()) - 1;
  }
  /// Adds a body with two points at the distance `length`. Their nominal positions are estimates.
  int link(std::string name, int a, int b, double length) {
    mechanism_.bodies.push_back({std::move(name), {a, b}, {}, length});
    return static_cast<int>(mechanism_.bodies.size()) - 1;
  }
  /// Adds points and vectors to those that a body carries.
  void carry(int body, const std::vector<int>& points, const std::vector<int>& vectors = {}) {
    Mechanism::Body& b = mechanism_.bodies[body];
    b.points.insert(b.points.end(), points.begin(), points.end());
    b.vectors.insert(b.vectors.end(), vectors.begin(), vectors.end());
  }
  /// Adds a joint between bodies a and b with the points and vectors that JointType names. Where
  /// the name is empty, release() gives one (name_joints()).
  void joint(Mechanism::JointType type, int a, int b, std::vector<int> points,
             std::vector<int> vectors = {}, std::string name = {}) {
    mechanism_.joints.push_back(
        {std::move(name), type, {a, b}, std::move(points), std::move(vectors)});
  }
  /// Adds a relative coordinate and returns it, so that the caller can set its other members. The
  /// reference is invalid once another coordinate is added.
  Mechanism::Coordinate& coordinate(std::string name, Mechanism::CoordinateType type) {
    Mechanism::Coordinate& c = mechanism_.coordinates.emplace_back();
    c.name = std::move(name);
    c.type = type;
    return c;
  }
  /// Add a coordinate of the type that the function is named after. Mechanism::Coordinate says what
  /// the parameters are, and coordinate() how long the reference is valid.
  Mechanism::Coordinate& angle(std::string name, const Mechanism::Direction& of,
                               const Mechanism::Direction& from = {},
                               const Mechanism::Direction& towards = {}) {
    Mechanism::Coordinate& c = coordinate(std::move(name), Mechanism::CoordinateType::angle);
    c.of = of;
    c.from = from;
    c.towards = towards;
    return c;
  }
  Mechanism::Coordinate& along(std::string name, int from, int to, int vector) {
    Mechanism::Coordinate& c = coordinate(std::move(name), Mechanism::CoordinateType::along);
    c.of = {-1, from, to};
    c.vector = vector;
    return c;
  }
  Mechanism::Coordinate& component(std::string name, int point, int axis) {
    Mechanism::Coordinate& c = coordinate(std::move(name), Mechanism::CoordinateType::component);
    c.point = point;
    c.axis = axis;
    return c;
  }
  /// Couples two to four coordinates: Σ factor · coordinate keeps its nominal value, where lengths
  /// are in metres (or the free unit) and angles in radians.
  void couple(std::string name, std::vector<Mechanism::Coupling::Term> terms) {
    mechanism_.couplings.push_back({std::move(name), std::move(terms)});
  }

  /// Returns the mechanism, after name_joints(). The builder must not be used any more.
  Mechanism release() {
    name_joints(mechanism_);
    return std::move(mechanism_);
  }

 private:
  Mechanism mechanism_;
};

}  // namespace desmo
