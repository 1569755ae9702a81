#include "formulations/formulation.h"

#include <string>

#include "cases/mechanism/formatted.h"
#include "formulations/motion/internals.h"

namespace desmo {

namespace {

const char* outcome_of(Status status) {
  switch (status) {
    case Status::solved:
      return "converged";
    case Status::not_converged:
      return "no convergence";
    case Status::singular:
      return "singular Jacobian";
    case Status::not_finite:
      return "the equations are not finite";
  }
  return "";
}

}  // namespace

PartCounts part_counts(const Formulation& f) {
  PartCounts sum;
  for (const DefinedPart& part : parts_of(f)) sum += part.solver->counts();
  return sum;
}

std::span<const double> Formulation::q() const {
  return std::span(stepping_of(*this).state().q).first(model_.coordinates());
}
std::span<const double> Formulation::qd() const {
  return std::span(stepping_of(*this).state().qd).first(model_.coordinates());
}
std::span<const double> Formulation::qdd() const {
  return std::span(stepping_of(*this).state().qdd).first(model_.coordinates());
}

double Formulation::value(const std::string& name, Level level) const {
  const PerLevel<std::span<const double>> values{q(), qd(), qdd()};
  return model_.value(name, values[level], level);
}

std::string describe(const Summary& s, const Model& m) {
  const char* const outcome = outcome_of(s.status);
  if (s.ok())
    return formatted("%s: %ld instants, %ld iterations, residual %.2e", outcome, s.instants,
                     s.iterations, s.residual);
  std::string result = formatted("%s at t = %.9g s, residual %.2e", outcome, s.time, s.residual);
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
