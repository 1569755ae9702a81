#include "formulations/base/summary.h"

#include <algorithm>

namespace desmo {

void BasicSummary::add(const BasicSummary& instant) {
  time = instant.time;
  iterations += instant.iterations;
  updates += instant.updates;
  sub_steps += instant.sub_steps;
  if (instant.status == Status::solved) {
    ++instants;
    residual = std::max(residual, instant.residual);
    return;
  }
  status = instant.status;
  group = instant.group;
  constraint = instant.constraint;
  residual = instant.residual;
}

}  // namespace desmo
