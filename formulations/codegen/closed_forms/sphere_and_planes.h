#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "formulations/codegen/order/closed_form.h"

namespace desmo::generate {

/// A point or direction in one dimension to three, by components.
using Vector = std::vector<Expr>;

/// Summed in the order of vec::dot, so that equal products are equal expressions.
Expr dot(const Vector& a, const Vector& b);

/// scale (‖x − centre‖² − radius2) = 0
struct Sphere {
  Vector centre;
  Expr radius2, scale;
};

/// normal · (x − centre) = offset, with the centre of the sphere.
struct Plane {
  Vector normal;
  Expr offset;
  /// Right-hand side of the plane's own equation, given those of all equations.
  std::function<Expr(const Vector& b)> right_side;
};

/// Equations of a point as one sphere and, for the other dimensions, planes: those that are
/// linear, and that in which each further sphere meets the first.
struct SphereAndPlanes {
  Sphere sphere;
  int sphere_row;
  std::vector<Plane> planes;
  std::vector<Expr> further_radii2;  ///< of the other spheres
};

/// Nothing when an equation is neither, or none is a sphere.
std::optional<SphereAndPlanes> as_sphere_and_planes(const Task& task);

}  // namespace desmo::generate
