#include "cases/mechanism/directions.h"

#include <algorithm>
#include <cmath>

namespace desmo {
namespace {

using Vec = Mechanism::Vec;

constexpr double rounding = 1e-12;
constexpr double parallel = 1e-8;

double largest(const Vec& x) { return std::max({std::abs(x[0]), std::abs(x[1]), std::abs(x[2])}); }

}  // namespace

std::optional<Vec> unit_vector(const Vec& x) {
  const double scale = largest(x);  // so that no square overflows or vanishes
  if (!(scale > 0)) return std::nullopt;
  const Vec y{x[0] / scale, x[1] / scale, x[2] / scale};
  const double length = std::sqrt(y[0] * y[0] + y[1] * y[1] + y[2] * y[2]);
  return Vec{y[0] / length, y[1] / length, y[2] / length};
}

std::optional<Vec> direction(const Vec& p, const Vec& q) {
  const Vec difference{q[0] - p[0], q[1] - p[1], q[2] - p[2]};
  if (largest(difference) <= rounding * std::max(largest(p), largest(q))) return std::nullopt;
  return unit_vector(difference);
}

std::optional<Vec> common_normal(const Vec& a, const Vec& b) {
  const Vec product{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                    a[0] * b[1] - a[1] * b[0]};
  if (largest(product) < parallel) return std::nullopt;
  return unit_vector(product);
}

}  // namespace desmo
