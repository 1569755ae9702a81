#include "cases/mechanism/directions.h"

#include <algorithm>
#include <cmath>

#include "cases/numbers/space.h"

namespace desmo {
namespace {

using Vec = Mechanism::Vec;

constexpr double rounding = 1e-12;  // points coincide when apart by ≤ rounding · max |component|
constexpr double parallel = 1e-8;   // unit vectors are parallel when |components of a × b| < this

double largest(const Vec& x) { return std::max({std::abs(x[0]), std::abs(x[1]), std::abs(x[2])}); }

}  // namespace

std::vector<Vec> shape_of(const Mechanism& mechanism, const Mechanism::Body& body) {
  std::vector<Vec> points;
  if (body.own) {
    for (const Mechanism::ExactVec& x : body.own->points) points.push_back(Mechanism::rounded(x));
    return points;
  }
  for (const int p : body.points) points.push_back(mechanism.points[p].position);
  return points;
}

std::optional<Vec> unit_vector(const Vec& x) {
  const double scale = largest(x);  // so that no square overflows or vanishes
  if (!(scale > 0)) return std::nullopt;
  const Vec y{x[0] / scale, x[1] / scale, x[2] / scale};
  const double length = std::sqrt(dot(y, y));
  return Vec{y[0] / length, y[1] / length, y[2] / length};
}

std::optional<Vec> direction(const Vec& p, const Vec& q) {
  const Vec difference{q[0] - p[0], q[1] - p[1], q[2] - p[2]};
  if (largest(difference) <= rounding * std::max(largest(p), largest(q))) return std::nullopt;
  return unit_vector(difference);
}

Mechanism::ExactVec near_unit(const Mechanism::ExactVec& x) {
  const double size = largest(Mechanism::rounded(x));
  if (!(size > 0)) return x;
  const int exponent = std::ilogb(size);
  return {x[0].scaled(-exponent), x[1].scaled(-exponent), x[2].scaled(-exponent)};
}

std::array<Remainder, 3> remainder_of(const Vec& unit, const Mechanism::ExactVec& along) {
  const Mechanism::ExactVec y = near_unit(along);
  const Derived length = sqrt(dot(y, y));
  std::array<Remainder, 3> remainder;
  for (int i = 0; i < 3; ++i) remainder[i] = (y[i] / length).about(unit[i]).remainder();
  return remainder;
}

std::optional<Vec> common_normal(const Vec& a, const Vec& b) {
  const Vec product = cross(a, b);
  if (largest(product) < parallel) return std::nullopt;
  return unit_vector(product);
}

}  // namespace desmo
