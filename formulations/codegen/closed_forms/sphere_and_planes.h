#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "formulations/codegen/order/closed_form.h"

namespace desmo::generate {

/// A point or direction in one, two or three dimensions.
using Vector = std::vector<Expr>;

/// Returns a · b, summed in the order of vec::dot, so that equal products share one node.
Expr dot(const Vector& a, const Vector& b);

/// The equation scale (‖x − centre‖² − radius2) = 0.
struct Sphere {
  Vector centre;
  Expr radius2, scale;
};

/// The equation normal · (x − centre) = offset, where centre is that of SphereAndPlanes::sphere.
struct Plane {
  Vector normal;
  Expr offset;
  /// Returns r of normal · ẋ = r. b: right-hand sides of the task's equations J ẋ = b.
  std::function<Expr(const Vector& b)> right_side;
};

/// The n equations of a point x (n) as one sphere and n − 1 planes. Each further sphere becomes the
/// plane of its intersection with the first.
struct SphereAndPlanes {
  Sphere sphere;
  int sphere_row;  ///< index of the sphere's equation in the task
  std::vector<Plane> planes;
  std::vector<Expr> further_radii2;  ///< squared radii of the further spheres
};

/// Returns the task's equations in this form; nullopt for more than three unknowns, for an equation
/// that is neither a sphere nor linear, and without a sphere.
std::optional<SphereAndPlanes> as_sphere_and_planes(const Task& task);

}  // namespace desmo::generate
