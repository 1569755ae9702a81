#include "formulations/modelling/frames/frames.h"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include "cases/mechanism/joint_forms.h"
#include "cases/numbers/space.h"
#include "formulations/modelling/coordinates/placement.h"
#include "formulations/modelling/frames/axes.h"

namespace desmo {

namespace {

using Direction = Mechanism::Direction;
using Exact = AxisMaker::Exact;
using nominal::Vec;

class FramePlanner {
 public:
  FramePlanner(FramedMechanism& framed, const Structure& structure)
      : framed_(framed),
        d_(framed.mechanism),
        rigid_(framed.rigid),
        structure_(structure),
        placement_(place_entities(d_, rigid_, structure, false)),
        axes_(framed),
        is_plane_(d_.dimension == 2),
        orientation_(rigid_.list.size()) {}

  void plan() {
    const int own_vectors = static_cast<int>(d_.vectors.size());
    for (const int r : framed_.tree.order) {
      orientation_[r] = r;
      if (framed_.tree.has_frame[r]) plan_frame(r);
    }
    for (const int r : framed_.tree.order)
      if (framed_.tree.has_frame[r]) rigid_.list[r].basis = basis_of(framed_.frames[r]);
    plan_cut_joints(framed_, axes_, orientation_, own_vectors);
  }

 private:
  Basis basis_of(const DerivedFrame& frame) const {
    Basis basis;
    basis.origin = frame.origin;
    for (const int v : frame.axes)
      if (v >= 0) basis.directions.push_back({v});
    return basis;
  }

  // ---- Frames, joint by joint of the tree ----

  void plan_frame(int r) {
    const TreeJoint& hanging = framed_.tree.hanging[r];
    DerivedFrame& frame = framed_.frames[r];
    using enum Mechanism::JointType;
    if (hanging.joint < 0) {
      place_origin(r, rigid_.list[r].points.front(), true);
      turn_freely(r);
      if (is_plane_) frame.first_angle = bearing(frame.axes[0]);
      return;
    }
    const Mechanism::Joint& j = d_.joints[hanging.joint];
    place_origin(r, j.points[slides(j.type) && !hanging.is_first ? 1 : 0], false);
    if (slides(j.type)) plan_travel(r, j);
    if (j.type == prismatic)
      keep_axes(r);
    else if (is_plane_)
      turn_in_plane(r);
    else if (j.type == universal)
      turn_about_two(r, j);
    else if (j.type == spherical)
      turn_freely(r);
    else if (turns(j.type))
      turn_about(r, j.vectors[0]);
    else
      throw std::logic_error("joint '" + j.name + "' has variables, but no frame");
  }

  void place_origin(int r, int point, bool of_its_own) {
    // A point that slides is this body's own, unless an earlier body derives it. Any other point of
    // the joint is shared with the parent.
    const TreeJoint& hanging = framed_.tree.hanging[r];
    const bool moves = hanging.joint >= 0 && slides(d_.joints[hanging.joint].type);
    framed_.frames[r].origin = of_its_own || (moves && framed_.deriving[point] != r)
                                   ? axes_.add_point(r, point, "origin")
                                   : point;
  }

  void plan_travel(int r, const Mechanism::Joint& j) {
    DerivedFrame& frame = framed_.frames[r];
    frame.travel =
        declared(r, [&](const Mechanism::Coordinate& c) { return is_distance_of(j, c); });
    const Vec& from = d_.points[j.points[0]].position;
    const Vec& to = d_.points[j.points[1]].position;
    using nominal::operator-;
    frame.start_travel = dot(to - from, d_.vectors[j.vectors[0]].direction);
  }

  void turn_in_plane(int r) {
    DerivedFrame& frame = framed_.frames[r];
    const int parent = framed_.tree.hanging[r].parent;
    frame.angle = declared_angle(r, Mechanism::none);
    Direction lead = rigid_.list[r].basis.directions.front(), from;
    if (frame.angle >= 0) {
      lead = d_.coordinates[frame.angle].of;
      from = d_.coordinates[frame.angle].from;
    }
    if (from.is_given())
      frame.from = axes_.find_or_add_axis(parent, unit(axes_.own(parent, from)), "axis");
    else if (parent != 0)
      frame.from = framed_.frames[parent].axes[0];
    frame.axes[0] = axes_.find_or_add_axis(r, unit(axes_.own(r, lead)), "x");
    frame.first_angle = bearing(frame.axes[0]) - (frame.from < 0 ? 0 : bearing(frame.from));
  }

  double bearing(int vector) const {
    const Vec& u = d_.vectors[vector].direction;
    return std::atan2(u[1], u[0]);
  }

  void turn_about(int r, int u) {
    DerivedFrame& frame = framed_.frames[r];
    const int parent = framed_.tree.hanging[r].parent;
    frame.angle = declared_angle(r, u);
    const Exact axis = axes_.own(r, u);
    Exact lead;
    if (frame.angle >= 0) {
      const Mechanism::Coordinate& c = d_.coordinates[frame.angle];
      lead = unit(axes_.own(r, c.of));
      frame.from = c.from.vector;
      frame.towards = c.towards.vector;
      frame.opposite = c.opposite;
    } else {
      lead = axes_.nearest_to_normal(r, axis);
      std::tie(frame.from, frame.towards) = axes_.find_or_add_normals(parent, u);
    }
    if (!are_normal(lead, axis)) lead = unit(across(lead, axis));
    frame.axes = {axes_.find_or_add_axis(r, lead, "x"),
                  axes_.find_or_add_axis(r, cross(axis, lead), "y"), u};
    const Vec &x = direction(frame.axes[0]), &f = direction(frame.from),
              &g = direction(frame.towards);
    frame.first_angle = std::atan2(dot(x, g), frame.opposite ? -dot(x, f) : dot(x, f));
  }

  void turn_about_two(int r, const Mechanism::Joint& j) {
    DerivedFrame& frame = framed_.frames[r];
    const TreeJoint& hanging = framed_.tree.hanging[r];
    const int a = j.vectors[hanging.is_first ? 1 : 0], b = j.vectors[hanging.is_first ? 0 : 1];
    std::tie(frame.from, frame.towards) = axes_.find_or_add_normals(hanging.parent, a);
    const Exact axis = axes_.own(r, b);
    Exact lead = axes_.nearest_to_normal(r, axis);
    if (!are_normal(lead, axis)) lead = unit(across(lead, axis));
    frame.axes = {axes_.find_or_add_axis(r, lead, "x"),
                  axes_.find_or_add_axis(r, cross(axis, lead), "y"),
                  axes_.find_or_add_axis(r, axis, "z")};
    const Vec &of_parent = direction(a), &of_body = direction(frame.axes[2]),
              &x = direction(frame.axes[0]);
    frame.first_angle =
        std::atan2(dot(of_body, direction(frame.towards)), dot(of_body, direction(frame.from)));
    frame.second_angle = std::atan2(dot(x, of_parent), dot(x, cross(of_parent, of_body)));
  }

  void keep_axes(int r) {
    const int parent = framed_.tree.hanging[r].parent;
    framed_.frames[r].axes = axes_of(parent);
    orientation_[r] = orientation_[parent];
  }

  void turn_freely(int r) {
    DerivedFrame& frame = framed_.frames[r];
    const std::array<Exact, 3> own = axes_.own_axes(r);
    static constexpr std::array names{"x", "y", "z"};
    for (int k = 0; k < (is_plane_ ? 1 : 3); ++k)
      frame.axes[k] = axes_.find_or_add_axis(r, own[k], names[k]);
    if (is_plane_) return;
    const bool is_free = framed_.tree.hanging[r].joint < 0;
    const std::array<int, 3> parent =
        is_free ? frame.axes : axes_of(framed_.tree.hanging[r].parent);
    Eigen::Matrix3d rotation;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        rotation(i, k) = is_free ? direction(frame.axes[k])[i]
                                 : dot(direction(parent[i]), direction(frame.axes[k]));
    Eigen::Quaterniond e(rotation);
    e.normalize();
    if (e.w() < 0) e.coeffs() *= -1;
    frame.orientation = {e.w(), e.x(), e.y(), e.z()};
  }

  /// Returns the axes of a body; those of the ground are added when they are first asked for.
  std::array<int, 3> axes_of(int r) {
    std::array<int, 3>& axes = framed_.frames[r].axes;
    static constexpr std::array names{"x", "y", "z"};
    for (int k = 0; r == 0 && k < (is_plane_ ? 1 : 3); ++k)
      if (axes[k] < 0) axes[k] = axes_.find_or_add_axis(0, axes_.own_axes(0)[k], names[k]);
    return axes;
  }

  /// Returns the first declared coordinate that can be a variable of a body's tree joint: it
  /// fulfils `measures`, and the body's group solves for it. Returns none when there is none.
  template <class Measures>
  int declared(int r, const Measures& measures) const {
    for (int c = 0; c < static_cast<int>(d_.coordinates.size()); ++c)
      if (placement_.of(d_.coordinates[c]) == structure_.of_body[r] && measures(d_.coordinates[c]))
        return c;
    return Mechanism::none;
  }

  /// Returns the declared angle about the axis of a tree joint. axis: none in the plane.
  int declared_angle(int r, int axis) const {
    const int parent = framed_.tree.hanging[r].parent;
    return declared(r, [&](const Mechanism::Coordinate& c) {
      return c.type == Mechanism::CoordinateType::angle && axes_.measures_turn(c, parent, r, axis);
    });
  }

  const Vec& direction(int vector) const { return d_.vectors[vector].direction; }

  FramedMechanism& framed_;
  Mechanism& d_;
  RigidBodies& rigid_;
  const Structure& structure_;
  Placement placement_;
  AxisMaker axes_;
  bool is_plane_;
  std::vector<int> orientation_;  // by rigid body, the first body with the same axes
};

}  // namespace

FramedMechanism put_frames(const Mechanism& d, const RigidBodies& rigid, const Structure& structure,
                           Modelling modelling) {
  FramedMechanism framed{d, rigid, make_tree(d, rigid, structure, modelling), {}, {}, {}, {}, {}};
  framed.frames.resize(rigid.list.size());
  framed.deriving = first_carriers(rigid.of_point, framed.tree);
  framed.deriving_vector = first_carriers(rigid.of_vector, framed.tree);
  FramePlanner(framed, structure).plan();
  return framed;
}

}  // namespace desmo
