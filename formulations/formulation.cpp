#include "formulations/formulation.h"

#include <stdexcept>

#include "formulations/base/part.h"
#include "formulations/structure/partition.h"

namespace desmo {

namespace {

std::span<const double> coordinates(const Model& m, const std::vector<double>& values) {
  return {values.data(), static_cast<std::size_t>(m.coordinates())};
}

[[noreturn]] void refuse_live_drivers() {
  throw std::logic_error("this formulation needs a motion known in advance (see is_live)");
}

}  // namespace

Summary Formulation::step_to_row(const LiveRow&, Level, int) { refuse_live_drivers(); }
void Formulation::return_to(std::span<const double>, double) { refuse_live_drivers(); }

const std::vector<DefinedPart>& parts_of(const Formulation& f) { return f.parts(); }

long Formulation::refactorisations() const {
  long sum = 0;
  for (const DefinedPart& part : parts()) sum += part.solver->refactorisations();
  return sum;
}

std::span<const double> Formulation::q() const { return coordinates(model_, state().q); }
std::span<const double> Formulation::qd() const { return coordinates(model_, state().qd); }
std::span<const double> Formulation::qdd() const { return coordinates(model_, state().qdd); }

}  // namespace desmo
