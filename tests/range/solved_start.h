#pragma once

#include <vector>

#include "formulations/variants.h"

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

}  // namespace desmo
