#include "formulations/model/scales.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "formulations/model/characteristic_lengths.h"

namespace desmo {

namespace {

/// Ratio of a largest rate to its natural size, up to which (≤) it counts as the rounding of zero.
constexpr double nothing = 1e-20;

double norm(std::span<const double> values, const Entity& e) {
  double norm = 0;
  for (const double x : values.subspan(e.first, e.size)) norm = std::hypot(norm, x);
  return norm;
}

}  // namespace

double nominal_size(const Model& m) {
  std::array<double, 3> low, high;
  low.fill(INFINITY);
  high.fill(-INFINITY);
  const auto values = [&](const Entity& e) {
    return (e.fixed ? m.fixed_values : m.estimate).data() + e.first;
  };
  for (const Entity& e : m.entities) {
    if (e.kind != EntityKind::point) continue;
    const double* x = values(e);
    for (int i = 0; i < e.size; ++i) {
      low[i] = std::min(low[i], x[i]);
      high[i] = std::max(high[i], x[i]);
    }
  }
  double distance = 0;
  for (const Constraint& c : m.constraints) {
    if (!joins_points(m, c)) continue;
    for (const EntityId e : c.operands)
      if (m.entities[e].kind == EntityKind::distance)
        distance = std::max(distance, std::abs(*values(m.entities[e])));
  }
  std::array<double, 3> extent;
  for (int i = 0; i < 3; ++i) extent[i] = std::max(0.0, high[i] - low[i]);
  const double size = std::max(std::hypot(extent[0], extent[1], extent[2]), distance);
  return size > 0 ? size : 1;
}

std::vector<double> nominal_magnitudes(const Model& m) {
  std::vector<double> magnitudes(m.coordinates(), 1);
  const double size = nominal_size(m);
  for (const Entity& e : m.entities)
    if (!e.fixed && is_length(e.kind)) std::fill_n(magnitudes.begin() + e.first, e.size, size);
  return magnitudes;
}

Scales make_scales(const Model& m, std::span<const ReferenceInstant> reference) {
  Scales s;
  s.length.position = nominal_size(m);
  for (const ReferenceInstant& instant : reference)
    for (const Entity& e : m.entities) {
      if (e.fixed) continue;
      PerLevel<double>& largest = is_length(e.kind) ? s.length : s.rotation;
      largest.velocity = std::max(largest.velocity, norm(instant.qd, e));
      largest.acceleration = std::max(largest.acceleration, norm(instant.qdd, e));
    }

  const double size = s.length.position, v = s.length.velocity, w = s.rotation.velocity;
  if (v <= nothing * size * w) s.length.velocity = size * w;
  if (w <= nothing * v / size) s.rotation.velocity = v / size;
  for (PerLevel<double>* of : {&s.length, &s.rotation}) {
    const double natural = of->velocity * of->velocity / of->position;
    if (of->acceleration <= nothing * natural) of->acceleration = natural;
  }
  return s;
}

double relative(double difference, double scale) {
  if (difference == 0) return 0;
  const double error = std::abs(difference) / scale;
  return std::isnan(error) ? INFINITY : error;
}

}  // namespace desmo
