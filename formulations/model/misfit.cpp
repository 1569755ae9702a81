#include "formulations/model/misfit.h"

#include <array>
#include <cmath>
#include <utility>

#include "formulations/model/constraint_at.h"

namespace desmo {

DisplayUnit Misfit::unit(const DisplayUnits& units) const {
  if (is_length(kind)) return units.length;
  return kind == EntityKind::angle ? units.angle : DisplayUnit{"1"};
}

std::vector<double> residual_of(const Model& m, const Constraint& c,
                                std::span<const double> state) {
  std::vector<double> phi(rows(c));
  ConstraintAt<double>(m, c, state.data()).residual(phi.data());
  return phi;
}

Misfit misfit_of(const Model& m, int constraint, int row, double residual,
                 std::span<const double> state) {
  const Constraint& c = m.constraints[constraint];
  Misfit result{.constraint = constraint};
  // norm of the derivatives by each operand
  std::array<double, max_operands> slope{};
  ConstraintAt<double>(m, c, state.data()).jacobian([&](int r, int operand, int, double value) {
    if (r == row) slope[operand] = std::hypot(slope[operand], value);
  });
  double chosen = 0;  // slope by the operand that would have to change
  // {it is a length, its slope} of that operand: a length goes before all others
  std::pair steepest{false, 0.};
  for (std::size_t k = 0; k < c.operands.size(); ++k) {
    const EntityKind kind = m.entities[c.operands[k]].kind;
    // An angle is often as steep as a direction: rounding must not choose the unit.
    const double first = kind == EntityKind::angle ? 1 + 0x1p-20 : 1;
    const std::pair steepness{is_length(kind), slope[k] * first};
    if (!(slope[k] > 0 && steepness > steepest)) continue;
    steepest = steepness;
    result.kind = kind;
    chosen = slope[k];
  }
  result.amount = std::abs(residual) / chosen;
  return result;
}

}  // namespace desmo
