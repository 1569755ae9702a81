#include "formulations/formulation.h"

namespace desmo {

namespace {

std::span<const double> coordinates(const Model& m, const std::vector<double>& values) {
  return {values.data(), static_cast<std::size_t>(m.coordinates())};
}

}  // namespace

long Formulation::refactorisations() const {
  long sum = 0;
  for (const DefinedPart& part : parts()) sum += part.solver->refactorisations();
  return sum;
}

std::span<const double> Formulation::q() const { return coordinates(model_, state().q); }
std::span<const double> Formulation::qd() const { return coordinates(model_, state().qd); }
std::span<const double> Formulation::qdd() const { return coordinates(model_, state().qdd); }

}  // namespace desmo
