#pragma once

#include <vector>

#include "formulations/variants.h"
#include "formulations/verification/range/driver_range.h"

namespace desmo {

/// Returns the position at t = 0; the estimate with the drivers' values where it is singular.
inline std::vector<double> solved_start(const Model& m) {
  const auto formulation = make_formulation(find_variant("block_automatic_klu"), m);
  std::vector<double> q = m.estimate;
  if (formulation->assemble(0, Level::position).ok())
    q.assign(formulation->q().begin(), formulation->q().end());
  for (const Driver& d : m.drivers)
    q[m.entities[d.coordinate].first] = sample(d.motion, 0.0).position;
  return q;
}

/// Returns the range of a driver from that position.
inline DriverRange range_of(const Model& m, int driver = 0, const RangeLimits& limits = {}) {
  return find_range(m, solved_start(m), driver, limits);
}

}  // namespace desmo
