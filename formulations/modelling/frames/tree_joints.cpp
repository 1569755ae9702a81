#include <array>
#include <string>

#include "cases/mechanism/joint_forms.h"
#include "cases/numbers/space.h"
#include "formulations/modelling/equations/equation_writer.h"
#include "formulations/modelling/frames/frames.h"

namespace desmo {

namespace {

/// A writer of the derivation of one frame.
template <int D>
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
    using enum Mechanism::JointType;
    const bool is_free = !joint_;  // then the origin is an unknown, too
    if constexpr (D == 2) {
      if (is_free || joint_->type != prismatic) turn_in_plane();
    } else if (is_free) {
      orient({});
    } else if (joint_->type == universal) {
      turn_about_two();
    } else if (joint_->type == spherical) {
      orient(w_.framed->frames[hanging_.parent].axes);
    } else if (joint_->type != prismatic) {
      turn_about(first_angle(), frame_.axes[2]);
    }
    if (!is_free && slides(joint_->type)) slide();
  }

 private:
  /// Turns x by φ from the ground's x axis, or by θ from a vector f of the parent: x = R(θ) f
  void turn_in_plane() {
    if (frame_.from < 0) return derive<PlanarDirection>("x", {axis(0), first_angle()}, {});
    derive<PlanarTurn<Between::vector_and_vector>>(
        "x", {axis(0), w_.vector(frame_.from), first_angle()}, {Derived(1)});
  }

  /// Turns about an axis u: x = ±cos θ f + sin θ g; y = u × x. f, g: `from` and `towards`
  void turn_about(EntityId angle, int u) {
    const std::array operands{axis(0), w_.vector(frame_.from), w_.vector(frame_.towards), angle};
    frame_.opposite ? derive<Turned<-1>>("x", operands, {}) : derive<Turned<1>>("x", operands, {});
    derive<Cross>("y", {axis(1), w_.vector(u), axis(0)}, {});
  }

  /// Turns about two axes, a of the parent and b of the body:
  /// b = cos θ₁ f + sin θ₁ g; w = a × b; x = cos θ₂ w + sin θ₂ a; y = b × x
  void turn_about_two() {
    const int a = joint_->vectors[hanging_.is_first ? 1 : 0];
    const EntityId second = w_.add_variable(EntityKind::angle, joint_->name + "/second angle",
                                            std::array{frame_.second_angle}, r_);
    derive<Turned<1>>(
        "z", {axis(2), w_.vector(frame_.from), w_.vector(frame_.towards), first_angle()}, {});
    const nominal::Vec product =
        cross(w_.mechanism.vectors[a].direction, w_.mechanism.vectors[frame_.axes[2]].direction);
    const EntityId between =
        w_.add_variable(EntityKind::vector, joint_->name + "/between", product, r_);
    derive<Cross>("between", {between, w_.vector(a), axis(2)}, {});
    derive<Turned<1>>("x", {axis(0), between, w_.vector(a), second}, {});
    derive<Cross>("y", {axis(1), axis(2), axis(0)}, {});
  }

  /// Turns freely: x and y are the first columns of [X Y Z] A(e); z = x × y. parent: X, Y, Z; not
  /// read for a free joint, whose X, Y, Z are the axes of space.
  void orient(const std::array<int, 3>& parent) {
    const EntityId e =
        w_.add_variable(EntityKind::orientation, name_ + "/orientation", frame_.orientation, r_);
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
    const EntityId travel = frame_.travel >= 0
                                ? w_.coordinates().coordinates[frame_.travel]
                                : w_.add_variable(EntityKind::distance, joint_->name + "/travel",
                                                  std::array{frame_.start_travel}, r_);
    std::array points{joint_->points[0], joint_->points[1]};
    if (frame_.travel >= 0) {
      const Mechanism::Direction& of = w_.mechanism.coordinates[frame_.travel].of;
      points = {of.from, of.to};
    }
    const int own = joint_->points[hanging_.is_first ? 0 : 1];
    const int operand = points[0] == own ? 0 : 1;
    points[operand] = frame_.origin;
    w_.derive<Along<D>>(
        EquationSource::joint, joint_->name + ": origin",
        {w_.point(points[0]), w_.point(points[1]), w_.vector(joint_->vectors[0]), travel}, {},
        operand);
  }

  EntityId first_angle() {
    if (frame_.angle >= 0) return w_.coordinates().coordinates[frame_.angle];
    return w_.add_variable(EntityKind::angle, (joint_ ? joint_->name : name_) + "/angle",
                           std::array{frame_.first_angle}, r_);
  }

  EntityId axis(int k) const { return w_.vector(frame_.axes[k]); }

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

}  // namespace

template <int D>
void write_frame(EquationWriter& w, int r) {
  FrameWriter<D>(w, r).write();
}

template void write_frame<2>(EquationWriter&, int);
template void write_frame<3>(EquationWriter&, int);

}  // namespace desmo
