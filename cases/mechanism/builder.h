#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cases/mechanism/mechanism.h"

namespace desmo {

/// Builder of a mechanism, step by step. Points, vectors and bodies are referred to by the returned
/// position.
///
///   MechanismBuilder builder("crank", 2);
///   const int a = builder.point("A", {0, 0}), b = builder.point("B", {0.05, 0});
///   const int crank = builder.body("crank", {a, b});
///   builder.carry(MechanismBuilder::ground, {a});
///   builder.joint(Mechanism::JointType::revolute, MechanismBuilder::ground, crank, {a});
///   Mechanism::Coordinate& angle =
///       builder.coordinate("angle", Mechanism::CoordinateType::angle);
///   angle.of = {-1, a, b};
///   angle.driven = true;
///   const Mechanism mechanism = builder.take();
class MechanismBuilder {
 public:
  explicit MechanismBuilder(std::string name, int dimension) {
    d_.name = std::move(name);
    d_.dimension = dimension;
    d_.bodies.push_back({"ground", {}, {}, {}});
  }

  static constexpr int ground = 0;

  int point(std::string name, const Mechanism::Vec& position) {
    d_.points.push_back({std::move(name), position});
    return static_cast<int>(d_.points.size()) - 1;
  }
  int vector(std::string name, const Mechanism::Vec& direction) {
    d_.vectors.push_back({std::move(name), direction, {}});
    return static_cast<int>(d_.vectors.size()) - 1;
  }
  int vector_along(std::string name, const Mechanism::Vec& direction, int from, int to) {
    const int v = vector(std::move(name), direction);
    d_.vectors[v].along = {from, to};
    return v;
  }
  int body(std::string name, std::vector<int> points, std::vector<int> vectors = {}) {
    d_.bodies.push_back({std::move(name), std::move(points), std::move(vectors), {}});
    return static_cast<int>(d_.bodies.size()) - 1;
  }
  /// Adds a body with two points, whose nominal positions are only estimates, and returns it.
  int link(std::string name, int a, int b, double length) {
    d_.bodies.push_back({std::move(name), {a, b}, {}, length});
    return static_cast<int>(d_.bodies.size()) - 1;
  }
  void carry(int body, const std::vector<int>& points, const std::vector<int>& vectors = {}) {
    auto& [name, own_points, own_vectors, length] = d_.bodies[body];
    own_points.insert(own_points.end(), points.begin(), points.end());
    own_vectors.insert(own_vectors.end(), vectors.begin(), vectors.end());
  }
  void joint(Mechanism::JointType type, int a, int b, std::vector<int> points,
             std::vector<int> vectors = {}) {
    d_.joints.push_back({d_.bodies[a].name + "-" + d_.bodies[b].name,
                         type,
                         {a, b},
                         std::move(points),
                         std::move(vectors)});
  }
  Mechanism::Coordinate& coordinate(std::string name, Mechanism::CoordinateType type) {
    Mechanism::Coordinate& c = d_.coordinates.emplace_back();
    c.name = std::move(name);
    c.type = type;
    return c;
  }

  Mechanism take() { return std::move(d_); }

  void set_length_unit(std::string unit) { d_.length_unit = std::move(unit); }

 private:
  Mechanism d_;
};

}  // namespace desmo
