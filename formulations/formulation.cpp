#include "formulations/formulation.h"

#include "formulations/stepping/formulation_core.h"

namespace desmo {

namespace {

std::span<const double> coordinates(const Model& m, const std::vector<double>& values) {
  return {values.data(), static_cast<std::size_t>(m.coordinates())};
}

}  // namespace

// Only FormulationCore may derive from Formulation.
FormulationCore& core_of(Formulation& f) { return static_cast<FormulationCore&>(f); }
const FormulationCore& core_of(const Formulation& f) {
  return static_cast<const FormulationCore&>(f);
}

long refactorisations(const Formulation& f) {
  long sum = 0;
  for (const DefinedPart& part : parts_of(f)) sum += part.solver->refactorisations();
  return sum;
}

std::span<const double> Formulation::q() const {
  return coordinates(model_, core_of(*this).state().q);
}
std::span<const double> Formulation::qd() const {
  return coordinates(model_, core_of(*this).state().qd);
}
std::span<const double> Formulation::qdd() const {
  return coordinates(model_, core_of(*this).state().qdd);
}

}  // namespace desmo
