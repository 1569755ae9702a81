// Intersection of a sphere with planes in one, two or three dimensions. Examples are a point on two
// circles or three spheres and a unit vector normal to two others. In one dimension, an example is
// the last component of a unit vector.

#include <utility>

#include "formulations/codegen/closed_forms/sphere_and_planes.h"

namespace desmo::generate {

namespace {

/// Returns a·a; replaces it, or else each of its terms, by the known value if there is one.
Expr square(const Vector& a, const Facts& facts) {
  const Expr whole = dot(a, a), known = facts.value(whole);
  if (known.id() != whole.id()) return known;
  Expr sum = facts.value(a[0] * a[0]);
  for (std::size_t i = 1; i < a.size(); ++i) sum = sum + facts.value(a[i] * a[i]);
  return sum;
}

/// Terms that position and rates share. The foot p is the point nearest to the centre that is in
/// all planes; without planes it is the centre. The line through p, parallel to all planes, meets
/// the sphere at the solution x.
struct Geometry {
  SphereAndPlanes given;
  Vector y;                     ///< x − centre
  Vector outward;               ///< w, direction of that line
  Expr aa = 1, ab = 0, bb = 1;  ///< a·a, a·b and b·b of two normals a and b
  Expr w2 = 1;                  ///< W = ‖w‖²
  Vector in_planes;             ///< coefficients of the normals in (p − centre) W
  Expr foot2 = 0;               ///< ‖p − centre‖² W
  bool through_centre = true;   ///< all planes contain the centre: p = centre

  Geometry(SphereAndPlanes found, const Task& task) : given(std::move(found)) {
    for (std::size_t i = 0; i < task.x.size(); ++i) y.push_back(task.x[i] - given.sphere.centre[i]);
    for (const Plane& p : given.planes) through_centre = through_centre && p.offset.is_zero();
    if (given.planes.empty())
      outward = {1};
    else if (given.planes.size() == 1)
      cut_by_one(task.facts);
    else
      cut_by_two(task.facts);
  }

 private:
  void cut_by_one(const Facts& facts) {
    const auto& [a, offset, unused] = given.planes[0];
    outward = {-a[1], a[0]};
    w2 = square(a, facts);
    in_planes = {offset};
    foot2 = offset * offset;
  }

  void cut_by_two(const Facts& facts) {
    const Vector &a = given.planes[0].normal, &b = given.planes[1].normal;
    const Expr alpha = given.planes[0].offset, beta = given.planes[1].offset;
    outward = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    aa = square(a, facts);
    bb = square(b, facts);
    ab = facts.value(dot(a, b));
    const bool known = !aa.moves() && !bb.moves() && !ab.moves();
    w2 = known || ab.is_zero() ? aa * bb - ab * ab : dot(outward, outward);
    in_planes = {alpha * bb - beta * ab, beta * aa - alpha * ab};
    foot2 = alpha * in_planes[0] + beta * in_planes[1];
  }
};

/// Solves the differentiated equations, whose matrix has the normals and y as rows.
struct RateSystem {
  Geometry g;
  Expr inverse;            ///< 1/W
  Expr inverse_off_foot2;  ///< 1/‖x − p‖²
  Vector off_foot;         ///< x − p

  Vector solve(const Vector& b) const {
    const std::vector<Plane>& planes = g.given.planes;
    Vector along;  // coefficients of the normals in the solution
    Expr rest = b[g.given.sphere_row] / (2 * g.given.sphere.scale);
    if (planes.size() == 1) {
      const Expr r = planes[0].right_side(b);
      along = {r * inverse};
      rest = rest - (g.in_planes[0] * inverse) * r;
    } else if (planes.size() == 2) {
      const Expr r = planes[0].right_side(b), s = planes[1].right_side(b);
      along = {r * (g.bb * inverse) - s * (g.ab * inverse),
               s * (g.aa * inverse) - r * (g.ab * inverse)};
      rest = rest - (g.in_planes[0] * inverse) * r - (g.in_planes[1] * inverse) * s;
    }
    const Expr outwards = rest * inverse_off_foot2;
    Vector x;
    for (std::size_t i = 0; i < g.y.size(); ++i) {
      Expr sum = outwards * off_foot[i];
      for (std::size_t k = 0; k < along.size(); ++k) sum = along[k] * planes[k].normal[i] + sum;
      x.push_back(sum);
    }
    return x;
  }
};

std::string name(const Geometry& g) {
  const std::size_t n = g.y.size();
  if (n == 1) return "square root";
  if (g.given.further_radii2.size() + 1 == n) return n == 2 ? "two circles" : "three spheres";
  if (n == 2) return "circle and line";
  return g.through_centre ? "normal of two" : "sphere and planes";
}

/// Returns monitors that refuse nearly parallel planes, and a sphere that hardly reaches their
/// common line.
std::vector<SizeMonitor> monitors(const Geometry& g, Expr discriminant) {
  std::vector<SizeMonitor> result;
  const Expr radius2 = g.given.sphere.radius2;
  // The discriminant of two circles r and s that meet at the angle γ is (r s sin γ)². It also tells
  // where their centres coincide.
  if (g.y.size() == 2 && g.given.further_radii2.size() == 1)
    return {{discriminant, 1e-8, magnitude(radius2 * g.given.further_radii2[0])}};
  if (g.w2.moves()) {
    const bool two = g.given.planes.size() == 2 && !g.ab.is_zero();
    const Expr size = two ? g.aa * g.bb : magnitude(g.w2);
    if (size.id() != g.w2.id()) result.push_back({g.w2, two ? 1e-8 : 1e-12, size});
  }
  if (discriminant.moves() && !(g.through_centre && !radius2.moves()))
    result.push_back({discriminant, 1e-8, magnitude(radius2) * g.w2});
  return result;
}

}  // namespace

std::optional<ClosedForm> solve_sphere(const Task& task) {
  std::optional<SphereAndPlanes> found = as_sphere_and_planes(task);
  if (!found) return std::nullopt;
  const Geometry g(std::move(*found), task);
  const auto& [centre, radius2, scale] = g.given.sphere;

  ClosedForm form;
  form.rule = name(g);
  const Expr pivot = dot(g.y, g.outward), branch = branch_of(pivot);
  form.roots.push_back({branch, pivot});

  const Expr discriminant = radius2 * g.w2 - g.foot2;  // ‖x − p‖² W
  // Two divisions, since W is known early: a single one for both reciprocals would have to wait for
  // the discriminant.
  RateSystem rates{g, Expr(1) / g.w2, {}, {}};
  rates.inverse_off_foot2 = g.through_centre ? Expr(1) / radius2 : g.w2 / discriminant;
  const Expr height = branch * (sqrt(discriminant) * rates.inverse);  // x − p = height w
  for (std::size_t i = 0; i < g.y.size(); ++i) {
    Expr foot = centre[i];
    for (std::size_t k = 0; k < g.given.planes.size(); ++k)
      foot = foot + (g.in_planes[k] * rates.inverse) * g.given.planes[k].normal[i];
    form.values.push_back(foot + height * g.outward[i]);
    rates.off_foot.push_back(g.through_centre ? g.y[i] : height * g.outward[i]);
  }
  if (g.y.size() == 1) form.consequences.emplace_back(g.y[0] * g.y[0], discriminant);
  form.cost = 2 * discriminant.moves() + 2 * g.w2.moves();
  form.monitors.sizes = monitors(g, discriminant);
  rates_by_equations(form, task.equations, [rates](const Vector& b) { return rates.solve(b); });
  return form;
}

}  // namespace desmo::generate
