#include "formulations/modelling/frames/frames.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "cases/mechanism/joint_forms.h"
#include "formulations/modelling/coordinates/coordinates.h"
#include "formulations/modelling/coordinates/placement.h"

namespace desmo {

namespace {

using Direction = Mechanism::Direction;
using Exact = AxisMaker::Exact;

/// Returns whether a rigid body carries a direction: a vector, or both points of a line.
bool carries(const RigidBodies& rigid, int body, const Direction& d) {
  const auto has = [&](const std::vector<int>& carriers) {
    return std::ranges::binary_search(carriers, body);
  };
  return d.is_line() ? has(rigid.of_point[d.from]) && has(rigid.of_point[d.to])
                     : has(rigid.of_vector[d.vector]);
}

class FramePlanner {
 public:
  FramePlanner(FramedMechanism& framed, const Structure& structure)
      : framed_(framed),
        mechanism_(framed.mechanism),
        rigid_(framed.rigid),
        structure_(structure),
        placement_(place_entities(mechanism_, rigid_, structure, false)),
        axes_(framed),
        is_plane_(mechanism_.dimension == 2) {}

  void plan() {
    for (const int r : framed_.tree.order)
      if (framed_.tree.has_frame[r]) plan_frame(r);
    for (const int r : framed_.tree.order)
      if (framed_.tree.has_frame[r]) set_basis(rigid_.list[r].basis, framed_.frames[r]);
    plan_cut_joints(framed_, axes_);
  }

 private:
  static void set_basis(Basis& basis, const DerivedFrame& frame) {
    basis = {.origin = frame.origin, .directions = {}};
    for (const int v : frame.axes)
      if (v >= 0) basis.directions.push_back({v});
  }

  void plan_frame(int r) {
    const TreeJoint& hanging = framed_.tree.hanging[r];
    DerivedFrame& frame = framed_.frames[r];
    const Mechanism::Joint* const joint =
        hanging.joint < 0 ? nullptr : &mechanism_.joints[hanging.joint];
    frame.origin = origin_of(r, joint);
    if (joint && slides(joint->type))
      frame.travel =
          declared(r, [&](const Mechanism::Coordinate& c) { return is_distance_of(*joint, c); });
    switch (hanging.turn) {
      case Turn::none:
        frame.axes = axes_of(hanging.parent);
        return;
      case Turn::in_plane:
        return turn_in_plane(frame, r);
      case Turn::about_axis:
        return turn_about(frame, r, joint->vectors[0]);
      case Turn::about_two_axes:
        return turn_about_two(frame, r, *joint);
      case Turn::freely:
        frame.axes = add_axes(r);
        if (joint) axes_of(hanging.parent);
    }
  }

  /// Returns the origin of a body's frame. joint: null where the body is free.
  int origin_of(int r, const Mechanism::Joint* joint) {
    if (!joint) return axes_.add_point(r, rigid_.list[r].points.front(), "origin");
    // A point that slides is this body's own, unless an earlier body derives it. Any other point of
    // the joint is shared with the parent.
    if (!slides(joint->type)) return joint->points[0];
    const int own = joint->points[framed_.tree.hanging[r].is_first ? 0 : 1];
    return framed_.deriving[own] == r ? own : axes_.add_point(r, own, "origin");
  }

  void turn_in_plane(DerivedFrame& frame, int r) {
    const auto& [parent, joint, is_first, turn] = framed_.tree.hanging[r];
    Direction lead = rigid_.list[r].basis.directions.front(), from;
    if (joint >= 0) frame.angle = declared_angle(r, Mechanism::none);
    if (frame.angle >= 0) {
      lead = mechanism_.coordinates[frame.angle].of;
      from = mechanism_.coordinates[frame.angle].from;
    }
    if (from.is_given())
      frame.from = axes_.find_or_add_axis(parent, unit_vector(axes_.own(parent, from)), "axis");
    else if (parent != 0)
      frame.from = framed_.frames[parent].axes[0];
    frame.axes[0] = axes_.find_or_add_axis(r, unit_vector(axes_.own(r, lead)), "x");
  }

  void turn_about(DerivedFrame& frame, int r, int u) {
    const int parent = framed_.tree.hanging[r].parent;
    const Exact axis = axes_.own(r, u);
    Exact lead;
    frame.angle = declared_angle(r, u);
    if (frame.angle >= 0) {
      const Mechanism::Coordinate& c = mechanism_.coordinates[frame.angle];
      lead = unit_vector(axes_.own(r, c.of));
      frame.from = c.from.vector;
      frame.towards = c.towards.vector;
      frame.opposite = c.opposite;
    } else {
      lead = nearest_to_normal(r, axis);
      std::tie(frame.from, frame.towards) = axes_.find_or_add_normals(parent, u);
    }
    set_x_and_y(frame, r, lead, axis);
    frame.axes[2] = u;
  }

  void turn_about_two(DerivedFrame& frame, int r, const Mechanism::Joint& j) {
    const auto& [parent, joint, is_first, turn] = framed_.tree.hanging[r];
    const int a = j.vectors[is_first ? 1 : 0], b = j.vectors[is_first ? 0 : 1];
    std::tie(frame.from, frame.towards) = axes_.find_or_add_normals(parent, a);
    const Exact axis = axes_.own(r, b);
    set_x_and_y(frame, r, nearest_to_normal(r, axis), axis);
    frame.axes[2] = axes_.find_or_add_axis(r, axis, "z");
  }

  /// Sets the x and y axes at right angles to a z axis; x is the part of `lead` normal to it.
  void set_x_and_y(DerivedFrame& frame, int r, const Exact& lead, const Exact& z) {
    const Exact x = are_normal(lead, z) ? lead : unit_vector(across(lead, z));
    frame.axes[0] = axes_.find_or_add_axis(r, x, "x");
    frame.axes[1] = axes_.find_or_add_axis(r, cross(z, x), "y");
  }

  /// Returns the direction of a body's basis that is most nearly normal to `axis`, scaled to
  /// length 1; the first one when others differ from it by rounding alone.
  Exact nearest_to_normal(int r, const Exact& axis) const {
    Exact best{};
    double least = 2;
    for (const Direction& d : rigid_.list[r].basis.directions) {
      const Exact u = unit_vector(axes_.own(r, d));
      if (const double along = std::abs(dot(u, axis).value); along < least - 1e-9) {
        least = along;
        best = u;
      }
    }
    return best;
  }

  /// Returns the axes of a body; those of the ground are added when they are first asked for.
  std::array<int, 3> axes_of(int r) {
    std::array<int, 3>& axes = framed_.frames[r].axes;
    if (axes[0] < 0) axes = add_axes(r);
    return axes;
  }

  /// Finds or adds vectors along a body's own axes.
  std::array<int, 3> add_axes(int r) {
    static constexpr std::array names{"x", "y", "z"};
    std::array<int, 3> axes = framed_.frames[r].axes;
    const std::array<Exact, 3> own = axes_.own_axes(r);
    for (int k = 0; k < (is_plane_ ? 1 : 3); ++k)
      axes[k] = axes_.find_or_add_axis(r, own[k], names[k]);
    return axes;
  }

  /// Returns the first declared coordinate that can be a variable of a body's tree joint: it
  /// fulfils `measures`, and the body's group solves for it. Returns none when there is none.
  template <class Measures>
  int declared(int r, const Measures& measures) const {
    for (int c = 0; c < static_cast<int>(mechanism_.coordinates.size()); ++c)
      if (placement_.of(mechanism_.coordinates[c]) == structure_.of_body[r] &&
          measures(mechanism_.coordinates[c]))
        return c;
    return Mechanism::none;
  }

  /// Returns the declared angle about the axis of a tree joint. axis: none in the plane.
  int declared_angle(int r, int axis) const {
    const int parent = framed_.tree.hanging[r].parent;
    return declared(r, [&](const Mechanism::Coordinate& c) {
      return c.type == Mechanism::CoordinateType::angle && measures_turn(c, parent, r, axis);
    });
  }

  /// Returns whether an angle is the turn of a body's tree joint: it goes from directions that the
  /// parent carries to one that the body carries. In space all are normal to the vector `axis`.
  bool measures_turn(const Mechanism::Coordinate& a, int parent, int body, int axis) const {
    if (!carries(rigid_, body, a.of)) return false;
    if (!a.from.is_given()) return parent == 0;
    if (!carries(rigid_, parent, a.from)) return false;
    if (is_plane_) return true;
    if (!carries(rigid_, parent, a.towards) || a.from.is_line() || a.towards.is_line())
      return false;
    const Exact u = axes_.own(parent, axis), f = axes_.own(parent, a.from),
                g = axes_.own(parent, a.towards);
    return are_normal(u, f) && are_normal(u, g) && are_normal(f, g) &&
           are_normal(axes_.own(body, axis), unit_vector(axes_.own(body, a.of)));
  }

  FramedMechanism& framed_;
  Mechanism& mechanism_;
  RigidBodies& rigid_;
  const Structure& structure_;
  Placement placement_;
  AxisMaker axes_;
  bool is_plane_;
};

}  // namespace

FramedMechanism put_frames(const Mechanism& mechanism, const RigidBodies& rigid,
                           const Structure& structure, Modelling modelling) {
  FramedMechanism framed{
      mechanism, rigid, make_tree(mechanism, rigid, structure, modelling), {}, {}, {}, {}, {}};
  framed.frames.resize(rigid.list.size());
  framed.deriving.assign(mechanism.points.size(), no_position);
  framed.deriving_vector.assign(mechanism.vectors.size(), no_position);
  const auto derive_all_of = [&](int r) {
    for (const int p : rigid.list[r].points) framed.deriving[p] = r;
    for (const int v : rigid.list[r].vectors) framed.deriving_vector[v] = r;
  };
  // From the last body of the tree to the first, then the ground: the first carrier stays.
  std::for_each(framed.tree.order.rbegin(), framed.tree.order.rend(), derive_all_of);
  derive_all_of(0);
  FramePlanner(framed, structure).plan();
  return framed;
}

}  // namespace desmo
