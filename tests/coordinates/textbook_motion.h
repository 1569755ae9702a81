#pragma once

// How a mechanism moves by textbooks: screws of joints, and the recursion of velocities and
// accelerations.

#include <Eigen/Dense>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "cases/mechanism/scene.h"
#include "formulations/model/model.h"
#include "formulations/model/partition.h"
#include "formulations/modelling/frames/frames.h"

namespace desmo::textbook_test {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// A mechanism at an instant of its motion, what it condenses to, and the textbook's motion of it.
class Instant {
 public:
  Instant(const Scene& scene, Modelling kind, double time);

  const Model m;

 private:
  const RigidBodies rigid_;

 public:
  const FramedMechanism framed;
  std::vector<double> q, qd;  // states
  MatrixXd jacobian;          // closures × unknowns that are not derived
  VectorXd gamma;             // Φ̇_q q̇ of closures without derived accelerations
  std::vector<Equation> closures;
  std::map<int, int> column;  // column of each coordinate that is not derived

  /// A point or vector and its rates. bias: its acceleration where those of the unknowns are 0.
  struct Rates {
    Vector3d value, velocity, bias;
    std::map<int, Vector3d> by;  // derivative by the unknown of each column
  };

  /// Returns the rates of an entity, moved by the body that derives it.
  Rates rates(EntityId e) const;

  /// Returns the rates of an entity as a body moves it.
  Rates rates(EntityId e, int body, bool is_point) const;

  /// Returns the framed body whose name a constraint's name begins with; −1: none.
  int body_of(std::string_view constraint) const;

 private:
  /// A freedom: δp = (turn × (p − through) + slide) δz.
  struct Screw {
    int column;
    Vector3d turn, through, slide;
  };
  struct Body {
    std::vector<Screw> screws;
    Vector3d origin = Vector3d::Zero(), origin_bias = origin, omega = origin, alpha = origin;
  };

  Vector3d at(const std::vector<double>& state, EntityId e) const;
  EntityId point(int p) const { return m.find(framed.mechanism.points[p].name); }
  EntityId vector(int v) const { return m.find(framed.mechanism.vectors[v].name); }

  /// Returns the framed body that derives an entity (−1: none does), and whether it is a point.
  std::pair<int, bool> carrier(EntityId e) const;

  /// Finds the closures, their Jacobian and gamma by desmo's condensation.
  void condense();
  /// Replaces Euler parameters e by turns about the three axes of the parent. These keep the norm
  /// of e: the first of its four columns becomes 0, and gamma includes what ë = −‖ė‖² e makes.
  void turn_euler_parameters();

  /// Finds the screws and accelerations of bodies, parents first.
  void move_bodies();
  void move_body(int r);

  PartDefinition part_;
  std::vector<Body> bodies_;
};

}  // namespace desmo::textbook_test
