#include "formulations/base/summary.h"

#include <algorithm>
#include <cstdio>

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

std::string describe(const Summary& s, const Model& m) {
  char text[160];
  if (s.ok()) {
    std::snprintf(text, sizeof text, "converged: %ld instants, %ld iterations, residual %.2e",
                  s.instants, s.iterations, s.residual);
    return text;
  }
  const char* reason = s.status == Status::singular        ? "singular Jacobian"
                       : s.status == Status::not_converged ? "no convergence"
                                                           : "the equations are not finite";
  std::snprintf(text, sizeof text, "%s at t = %.9g s, residual %.2e", reason, s.time, s.residual);
  std::string result = text;
  if (s.group >= 0) result += ", group '" + m.groups[s.group].name + "'";
  if (s.constraint >= 0) {
    const Constraint& c = m.constraints[s.constraint];
    result += ", constraint '" + c.name + "'";
    if (s.status == Status::not_finite && constraint_kind_name(c.kind) == "coupling_by_table")
      result += ", which is outside of its table";
  }
  return result;
}

}  // namespace desmo
