#pragma once

#include <algorithm>
#include <variant>
#include <vector>

#include "tests/mechanisms.h"

namespace desmo {

/// Returns the instants that tests go through: all of a motion, or with sanitizers its begin.
inline TimeGrid tested(TimeGrid grid) {
  if (DESMO_SANITIZED) grid.instants = std::min(grid.instants, 21);
  return grid;
}

/// Returns `count` times of a grid, evenly spread, both ends included.
inline std::vector<double> sampled(const TimeGrid& grid, int count) {
  std::vector<double> times;
  for (long i = 0; i < count; ++i)
    times.push_back(grid.time(static_cast<int>(i * (grid.instants - 1) / (count - 1))));
  return times;
}

/// Returns a polynomial or harmonic motion z(t) times a factor; throws for a spline.
inline Motion enlarged(Motion motion, double factor) {
  if (auto* p = std::get_if<Polynomial>(&motion)) {
    for (Derived& c : p->coefficients) c.value *= factor;
  } else {
    auto& sum = std::get<HarmonicSum>(motion);
    sum.mean.value *= factor;
    for (HarmonicSum::Term& term : sum.terms) term.amplitude.value *= factor;
  }
  return motion;
}

/// Returns the scene with all lengths times a factor; angles are unchanged.
inline Scene enlarged(Scene scene, double factor) {
  for (Mechanism::Point& p : scene.mechanism.points) {
    for (double& x : p.position) x *= factor;
    p.remainder = {};
  }
  for (Mechanism::Body& b : scene.mechanism.bodies)
    if (b.length) b.length = b.length->value * factor;
  auto motion = scene.motions.begin();
  for (Mechanism::Coordinate& c : scene.mechanism.coordinates) {
    const bool length = c.type != Mechanism::CoordinateType::angle;
    if (length && c.estimate) *c.estimate *= factor;
    if (length && c.driven) *motion = enlarged(*motion, factor);
    if (c.driven) ++motion;
  }
  return scene;
}

}  // namespace desmo
