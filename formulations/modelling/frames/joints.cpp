// Joints of mechanisms with frames. A joint of the tree derives the frame of a body. A cut joint
// closes a loop: shared points by their relations (body_equations.cpp), shared vectors and spatial
// sliding joints here. Angles of universal joints and offsets in the plane close by
// joint_equations.cpp.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "cases/mechanism/joint_forms.h"
#include "formulations/modelling/equations/equation_writer.h"

namespace desmo {

namespace {

using Exact = AxisMaker::Exact;
using nominal::Vec;

/// The sine between two shared vectors above which the second one tells more than the first.
constexpr double min_sine = 1e-6;

/// A writer of the derivation of one frame. Internal variables start at their values in the
/// nominal position.
class FrameWriter {
 public:
  FrameWriter(EquationWriter& w, int r)
      : w_(w),
        r_(r),
        frame_(w.framed->frames[r]),
        hanging_(w.framed->tree.hanging[r]),
        joint_(hanging_.joint < 0 ? nullptr : &w.mechanism.joints[hanging_.joint]),
        name_(w.mechanism.bodies[w.rigid.list[r].bodies.front()].name) {}

  void write() {
    turn();
    if (joint_ && slides(joint_->type)) slide();
  }

 private:
  void turn() {
    switch (hanging_.turn) {
      case Turn::none:
        return;
      case Turn::in_plane:
        return turn_in_plane();
      case Turn::about_axis:
        return turn_about();
      case Turn::about_two_axes:
        return turn_about_two();
      case Turn::freely:
        return turn_freely();
    }
  }

  /// Turns x by φ from the ground's x axis, or by θ from a vector f of the parent: x = R(θ) f
  void turn_in_plane() {
    const auto bearing = [&](int v) { return std::atan2(drawn(v)[1], drawn(v)[0]); };
    const double x = bearing(frame_.axes[0]);
    if (frame_.from < 0) return derive<PlanarDirection>("x", {axis(0), first_angle(x)}, {});
    derive<PlanarTurn<Between::vector_and_vector>>(
        "x", {axis(0), w_.vector(frame_.from), first_angle(x - bearing(frame_.from))},
        {Derived(1)});
  }

  /// Turns about an axis u: x = ±cos θ f + sin θ g; y = u × x. f, g: `from` and `towards`
  void turn_about() {
    const Vec &x = drawn(frame_.axes[0]), &f = drawn(frame_.from), &g = drawn(frame_.towards);
    const double start = std::atan2(dot(x, g), frame_.opposite ? -dot(x, f) : dot(x, f));
    const std::array operands{axis(0), w_.vector(frame_.from), w_.vector(frame_.towards),
                              first_angle(start)};
    frame_.opposite ? derive<Turned<-1>>("x", operands, {}) : derive<Turned<1>>("x", operands, {});
    derive<Cross>("y", {axis(1), axis(2), axis(0)}, {});
  }

  /// Turns about two axes, a of the parent and b of the body:
  /// b = cos θ₁ f + sin θ₁ g; w = a × b; x = cos θ₂ w + sin θ₂ a; y = b × x
  void turn_about_two() {
    const int of_parent = joint_->vectors[hanging_.is_first ? 1 : 0];
    const EntityId a = w_.vector(of_parent), f = w_.vector(frame_.from),
                   g = w_.vector(frame_.towards);
    const Vec &b = drawn(frame_.axes[2]), &x = drawn(frame_.axes[0]);
    const Vec product = cross(drawn(of_parent), b);
    const EntityId second = add_angle(joint_->name + "/second angle",
                                      std::atan2(dot(x, drawn(of_parent)), dot(x, product)));
    const EntityId first =
        first_angle(std::atan2(dot(b, drawn(frame_.towards)), dot(b, drawn(frame_.from))));
    derive<Turned<1>>("z", {axis(2), f, g, first}, {});
    const EntityId w = w_.add_variable(EntityKind::vector, joint_->name + "/between", product, r_);
    derive<Cross>("between", {w, a, axis(2)}, {});
    derive<Turned<1>>("x", {axis(0), w, a, second}, {});
    derive<Cross>("y", {axis(1), axis(2), axis(0)}, {});
  }

  /// Turns freely: x and y are the first columns of [X Y Z] A(e); z = x × y. X, Y, Z: axes of the
  /// parent; of a free joint, those of space.
  void turn_freely() {
    const std::array<int, 3>& parent = w_.framed->frames[hanging_.parent].axes;
    Eigen::Matrix3d rotation;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        rotation(i, k) =
            joint_ ? dot(drawn(parent[i]), drawn(frame_.axes[k])) : drawn(frame_.axes[k])[i];
    Eigen::Quaterniond start(rotation);
    start.normalize();
    if (start.w() < 0) start.coeffs() *= -1;
    const EntityId e = w_.add_variable(EntityKind::orientation, name_ + "/orientation",
                                       std::array{start.w(), start.x(), start.y(), start.z()}, r_);
    w_.constrain<Unit<4>>(EquationSource::body, name_ + ": orientation norm", {e}, {});
    if (!joint_) {
      derive<EulerAxis<0>>("x", {axis(0), e}, {});
      derive<EulerAxis<1>>("y", {axis(1), e}, {});
    } else {
      const EntityId x = w_.vector(parent[0]), y = w_.vector(parent[1]), z = w_.vector(parent[2]);
      derive<EulerAxisOn<0>>("x", {axis(0), x, y, z, e}, {});
      derive<EulerAxisOn<1>>("y", {axis(1), x, y, z, e}, {});
    }
    derive<Cross>("z", {axis(2), axis(0), axis(1)}, {});
  }

  /// Slides: Q = P + s u. The origin is one of these points, or stands in its place.
  void slide() {
    Mechanism::Direction line = joint_->line();
    EntityId travel;
    if (frame_.travel >= 0) {
      line = w_.mechanism.coordinates[frame_.travel].of;
      travel = w_.coordinates().coordinates[frame_.travel];
    } else {
      const double start =
          dot(Drawing<double>{w_.mechanism}.direction(line), drawn(joint_->vectors[0]));
      travel =
          w_.add_variable(EntityKind::distance, joint_->name + "/travel", std::array{start}, r_);
    }
    const int operand = line.from == joint_->points[hanging_.is_first ? 0 : 1] ? 0 : 1;
    (operand == 0 ? line.from : line.to) = frame_.origin;
    w_.constrain(
        EquationSource::joint, joint_->name + ": origin",
        w_.mechanism.dimension == 2 ? kind_index<Along<2>>() : kind_index<Along<3>>(),
        std::array{w_.point(line.from), w_.point(line.to), w_.vector(joint_->vectors[0]), travel},
        {}, operand);
  }

  /// Returns the declared angle of the joint; where there is none, adds one. start: its estimate
  /// [rad]
  EntityId first_angle(double start) {
    if (frame_.angle >= 0) return w_.coordinates().coordinates[frame_.angle];
    return add_angle((joint_ ? joint_->name : name_) + "/angle", start);
  }

  EntityId add_angle(std::string name, double start) {
    return w_.add_variable(EntityKind::angle, std::move(name), std::array{start}, r_);
  }

  EntityId axis(int k) const { return w_.vector(frame_.axes[k]); }
  const Vec& drawn(int vector) const { return w_.mechanism.vectors[vector].direction; }

  template <class Kind>
  void derive(const char* what, const std::array<EntityId, Kind::operand_sizes.size()>& operands,
              const std::array<Derived, Kind::constants>& dimensions) {
    w_.derive<Kind>(EquationSource::body, name_ + ": " + what, operands, dimensions);
  }

  EquationWriter& w_;
  int r_;
  const DerivedFrame& frame_;
  const TreeJoint& hanging_;
  const Mechanism::Joint* joint_;  // null: a free joint
  std::string name_;
};

/// Closes the vectors that a body shares with earlier bodies. In the plane: by the product of the
/// vector with its normal. In space, the first vector shared with another body closes by products
/// with two of its normals; a turn about the vector stays free. A further one shared with that body
/// closes by the product with the normal of both, unless they are parallel.
void close_shared_vectors(FramedMechanism& framed, AxisMaker& axes, int r) {
  std::vector<std::pair<int, int>> closed;  // other bodies, each with a vector that is closed
  const std::vector<int> vectors = framed.rigid.list[r].vectors;
  for (const int v : vectors) {
    const int other = framed.deriving_vector[v];
    if (other == r || framed.rigid.list[r].basis.has_vector(v) ||
        framed.frames[other].axes == framed.frames[r].axes)
      continue;
    const Exact u = axes.own(r, v);
    const auto before = std::ranges::find(closed, other, &std::pair<int, int>::first);
    if (framed.mechanism.dimension == 2) {
      framed.vectors.push_back({v, axes.find_or_add_axis(r, cross({0, 0, 1}, u), "normal")});
    } else if (before == closed.end()) {
      const auto [first, second] = axes.find_or_add_normals(r, v);
      framed.vectors.insert(framed.vectors.end(), {{v, first}, {v, second}});
    } else {
      const Exact normal = cross(axes.own(r, before->second), u);
      if (!(sqrt(dot(normal, normal)).value > min_sine)) continue;
      framed.vectors.push_back({v, axes.find_or_add_axis(r, unit_vector(normal), "normal")});
    }
    closed.emplace_back(other, v);
  }
}

/// Closes a spatial sliding joint: the line between its points is normal to two vectors of a body
/// that carries the axis.
void close_sliding_joint(FramedMechanism& framed, AxisMaker& axes, int joint) {
  const Mechanism::Joint& j = framed.mechanism.joints[joint];
  const int u = j.vectors[0];
  for (const int b : {j.bodies[1], j.bodies[0]}) {
    const int r = framed.rigid.of_body[b];
    if (!framed.tree.has_frame[r] || !std::ranges::binary_search(framed.rigid.of_vector[u], r))
      continue;
    const auto [first, second] = axes.find_or_add_normals(r, u);
    framed.lines.insert(framed.lines.end(), {{joint, first}, {joint, second}});
    return;
  }
}

}  // namespace

void plan_cut_joints(FramedMechanism& framed, AxisMaker& axes) {
  for (const int r : framed.tree.order)
    if (framed.tree.has_frame[r]) close_shared_vectors(framed, axes, r);
  if (framed.mechanism.dimension == 2) return;
  for (std::size_t i = 0; i < framed.mechanism.joints.size(); ++i) {
    const Mechanism::Joint& j = framed.mechanism.joints[i];
    const std::vector<int>& of_body = framed.rigid.of_body;
    if (!framed.tree.is_of_tree[i] && slides(j.type) &&
        of_body[j.bodies[0]] != of_body[j.bodies[1]])
      close_sliding_joint(framed, axes, static_cast<int>(i));
  }
}

void write_frame(EquationWriter& w, int r) { FrameWriter(w, r).write(); }

void write_cut_joints(EquationWriter& w) {
  const int product = w.mechanism.dimension == 2 ? kind_index<Dot<2>>() : kind_index<Dot<3>>();
  for (const auto& [vector, normal] : w.framed->vectors)
    w.constrain(EquationSource::joint, w.text({vector}) + " with " + w.text({normal}), product,
                std::array{w.vector(vector), w.vector(normal)}, std::array{Derived(0)});
  for (const auto& [joint, normal] : w.framed->lines) {
    const Mechanism::Joint& j = w.mechanism.joints[joint];
    w.begin(w.rigid.of_body[j.bodies[0]], w.rigid.of_body[j.bodies[1]]);
    w.constrain<Projection<3>>(EquationSource::joint, j.name + ": off along " + w.text({normal}),
                               {w.vector(normal), w.point(j.points[0]), w.point(j.points[1])},
                               {Derived(0)});
  }
}

}  // namespace desmo
