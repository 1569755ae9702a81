#include "formulations/codegen/closed_forms/sphere_and_planes.h"

#include <map>
#include <utility>

#include "formulations/codegen/record/expansion.h"
#include "formulations/codegen/record/expression.h"

namespace desmo::generate {

namespace {

/// Returns the sphere of an equation with one square along each axis, all of one scale. Returns
/// nullopt for any other equation.
std::optional<Sphere> as_sphere(const Quadratic& q, std::size_t n) {
  if (!q.rest.is_constant()) return std::nullopt;
  Sphere s{Vector(n), 0, 0};
  std::vector<bool> found(n, false);
  for (const Quadratic::Product& p : q.products) {
    if (p.a.constant.id() != p.b.constant.id()) return std::nullopt;
    std::size_t axis = n;
    for (std::size_t i = 0; i < n; ++i) {
      if (p.a.coefficient[i].id() != p.b.coefficient[i].id()) return std::nullopt;
      if (p.a.coefficient[i].is_zero()) continue;
      if (axis < n) return std::nullopt;  // the square contains two unknowns
      axis = i;
    }
    if (axis == n || found[axis]) return std::nullopt;
    found[axis] = true;
    const Expr k = p.a.coefficient[axis], scale = p.scale * (k * k);
    if (!s.scale.is_zero() && s.scale.id() != scale.id()) return std::nullopt;
    s.scale = scale;
    s.centre[axis] = -p.a.constant / k;
  }
  for (const bool f : found)
    if (!f) return std::nullopt;
  s.radius2 = -q.rest.constant / s.scale;
  return s;
}

/// Returns the plane in which another sphere, the equation `row`, meets the first: the difference
/// of their equations.
Plane plane_between(const Sphere& first, int first_row, const Sphere& other, int row) {
  Vector normal;
  for (std::size_t i = 0; i < first.centre.size(); ++i)
    normal.push_back(other.centre[i] - first.centre[i]);
  const Expr offset = (dot(normal, normal) + (first.radius2 - other.radius2)) * 0.5;
  return {normal, offset,
          [first_row, row, first_scale = first.scale, scale = other.scale](const Vector& b) {
            return (b[first_row] / first_scale - b[row] / scale) * 0.5;
          }};
}

}  // namespace

Expr dot(const Vector& a, const Vector& b) {
  Expr sum = a[0] * b[0];
  for (std::size_t i = 1; i < a.size(); ++i) sum = sum + a[i] * b[i];
  return sum;
}

std::optional<SphereAndPlanes> as_sphere_and_planes(const Task& task) {
  const std::size_t n = task.x.size();
  if (n > 3) return std::nullopt;
  std::vector<std::pair<int, Sphere>> spheres;
  std::vector<std::pair<int, Vector>> flat;
  for (std::size_t r = 0; r < n; ++r) {
    const int row = static_cast<int>(r);
    const std::optional<Quadratic> q = expand(task.equations[r], task.x);
    if (!q) return std::nullopt;
    if (q->products.empty())
      flat.emplace_back(row, q->rest.coefficient);
    else if (std::optional<Sphere> s = as_sphere(*q, n))
      spheres.emplace_back(row, std::move(*s));
    else
      return std::nullopt;
  }
  if (spheres.empty()) return std::nullopt;

  SphereAndPlanes found{spheres[0].second, spheres[0].first, {}, {}};
  std::map<int, Expr> at_centre;
  for (std::size_t i = 0; i < n; ++i) at_centre.emplace(task.x[i].id(), found.sphere.centre[i]);
  for (const auto& [row, normal] : flat)
    found.planes.push_back({normal, -substitute(task.equations[row], at_centre),
                            [row = row](const Vector& b) { return b[row]; }});
  for (std::size_t k = 1; k < spheres.size(); ++k) {
    const auto& [row, other] = spheres[k];
    found.planes.push_back(plane_between(found.sphere, found.sphere_row, other, row));
    found.further_radii2.push_back(other.radius2);
  }
  return found;
}

}  // namespace desmo::generate
