#include <array>
#include <cmath>
#include <cstddef>

#include "cases/mechanism/drawing.h"
#include "formulations/modelling/equations/equation_writer.h"

namespace desmo {

namespace {

bool is_angle(const Mechanism& d, const Mechanism::Coupling::Term& term) {
  return d.coordinates[term.coordinate].type == Mechanism::CoordinateType::angle;
}

/// Returns the term that Φ has the unit of: the largest factor of a length or, where there are
/// none, of an angle.
const Mechanism::Coupling::Term& leading_term(const Mechanism& d, const Mechanism::Coupling& c) {
  const Mechanism::Coupling::Term* leading = &c.terms.front();
  for (const Mechanism::Coupling::Term& term : c.terms) {
    const bool is_larger = std::abs(term.factor.value) > std::abs(leading->factor.value);
    if (is_angle(d, term) == is_angle(d, *leading) ? is_larger : !is_angle(d, term))
      leading = &term;
  }
  return *leading;
}

template <std::size_t N>
void write(EquationWriter& w, const Mechanism::Coupling& coupling) {
  const Mechanism& d = w.mechanism;
  const Derived unit = leading_term(d, coupling).factor;
  std::array<EntityId, N> operands;
  std::array<Derived, N + 1> dimensions;
  Derived sum = 0;
  double magnitude = 0;
  for (std::size_t k = 0; k < N; ++k) {
    const auto& [coordinate, factor] = coupling.terms[k];
    operands[k] = w.coordinates().coordinates[coordinate];
    dimensions[k] = factor / unit;
    const Derived term = dimensions[k] * Drawing<Derived>{d}.value(d.coordinates[coordinate]);
    sum = sum + term;
    magnitude += std::abs(term.value);
  }
  dimensions[N] = is_rounding(sum.value, magnitude) ? Derived(0) : sum;
  w.constrain<Coupling<N>>(Origin::joint, coupling.name + ": coupling", operands, dimensions);
}

}  // namespace

void write_coupling_equations(EquationWriter& w) {
  for (const Mechanism::Coupling& coupling : w.mechanism.couplings) switch (coupling.terms.size()) {
      case 2:
        write<2>(w, coupling);
        break;
      case 3:
        write<3>(w, coupling);
        break;
      default:
        write<4>(w, coupling);
    }
}

}  // namespace desmo
