#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cases/mechanism/drawing.h"
#include "cases/mechanism/formatted.h"
#include "formulations/modelling/equations/equation_writer.h"

namespace desmo {

namespace {

/// Returns the term whose unit Φ has: the length with the largest |factor| or, when there is no
/// length, the angle with the largest one.
const Mechanism::Coupling::Term& leading_term(const Mechanism& mechanism,
                                              const Mechanism::Coupling& c) {
  return *std::ranges::max_element(c.terms, {}, [&](const Mechanism::Coupling::Term& term) {
    const auto type = mechanism.coordinates[term.coordinate].type;
    return std::pair(type != Mechanism::CoordinateType::angle, std::abs(term.factor.value));
  });
}

void constrain(EquationWriter& w, const Mechanism::Coupling& coupling, int kind,
               const std::vector<Derived>& dimensions) {
  std::vector<EntityId> operands;
  for (const Mechanism::Coupling::Term& term : coupling.terms)
    operands.push_back(w.coordinates().coordinates[term.coordinate]);
  w.constrain(EquationSource::joint, coupling.name + ": coupling", kind, operands, dimensions);
}

void write_sum(EquationWriter& w, const Mechanism::Coupling& coupling) {
  static constexpr std::array kinds{kind_index<Coupling<2>>(), kind_index<Coupling<3>>(),
                                    kind_index<Coupling<4>>()};
  const Mechanism& mechanism = w.mechanism;
  const Derived unit = leading_term(mechanism, coupling).factor;
  std::vector<Derived> dimensions;
  Derived sum = 0;
  double magnitude = 0;
  for (const auto& [coordinate, factor] : coupling.terms) {
    dimensions.push_back(factor / unit);
    const Derived term =
        dimensions.back() * Drawing<Derived>{mechanism}.value(mechanism.coordinates[coordinate]);
    sum = sum + term;
    magnitude += std::abs(term.value);
  }
  dimensions.push_back(is_rounding(sum.value, magnitude) ? Derived(0) : sum);
  constrain(w, coupling, kinds[coupling.terms.size() - Mechanism::Coupling::min_terms], dimensions);
}

/// Returns the numbers of a table (formulations/constraints/table.h).
std::vector<Derived> numbers_of(const Mechanism::Coupling::Table& table) {
  const Spline f = make_spline(table.arguments, table.values, table.ends);
  const std::size_t n = f.pieces().size();
  std::vector<Derived> numbers{static_cast<double>(n), table.repeats() ? 1.0 : 0.0, 0};
  if (table.repeats()) numbers[2] = Derived(table.values.back()) - table.values.front();
  numbers.insert(numbers.end(), f.knots().begin(), f.knots().end());
  for (const Spline::Piece& piece : f.pieces())
    numbers.insert(numbers.end(), piece.begin(), piece.end());
  return numbers;
}

/// Returns the value of a coupling's table at the drawn value of its second coordinate. Throws
/// std::invalid_argument when that is outside of the table.
Derived drawn_value(const EquationWriter& w, const Mechanism::Coupling& coupling,
                    const std::vector<Derived>& numbers) {
  const auto& [coordinate, factor] = coupling.terms[1];
  const Mechanism::Coordinate& c = w.mechanism.coordinates[coordinate];
  const Derived at = factor * Drawing<Derived>{w.mechanism}.value(c);
  const auto [piece, turns] =
      find_in_table<double>([&](int k) { return numbers[k].value; }, at.value);
  const int n = static_cast<int>(numbers[0].value);
  const Derived &first = numbers[3], &last = numbers[3 + n];
  if (piece < 0)
    throw std::invalid_argument(
        "coupling '" + coupling.name + "': '" + c.name + "' is drawn at " +
        formatted("%g, outside of its table, from %g to %g; draw it there, or let the table repeat",
                  at.value, first.value, last.value));
  const Derived t = at - (last - first) * turns - numbers[3 + piece];
  const Derived* const a = &numbers[4 + n + 4 * piece];
  return ((a[3] * t + a[2]) * t + a[1]) * t + a[0] + numbers[2] * turns;
}

void write_table(EquationWriter& w, const Mechanism::Coupling& coupling) {
  const Mechanism& mechanism = w.mechanism;
  const std::vector<Derived> numbers = numbers_of(*coupling.table);
  const Derived unit = Derived(1) / coupling.terms[0].factor;
  const Derived drawn = unit * drawn_value(w, coupling, numbers);
  const Mechanism::Coordinate& first = mechanism.coordinates[coupling.terms[0].coordinate];
  const Derived from =
      coupling.table->from.value_or(Drawing<Derived>{mechanism}.value(first) - drawn).rounded();
  std::vector<Derived> dimensions{unit, coupling.terms[1].factor, from};
  dimensions.insert(dimensions.end(), numbers.begin(), numbers.end());
  constrain(w, coupling, kind_index<TableCoupling>(), dimensions);
}

}  // namespace

void write_coupling_equations(EquationWriter& w) {
  for (const Mechanism::Coupling& coupling : w.mechanism.couplings)
    coupling.table ? write_table(w, coupling) : write_sum(w, coupling);
}

}  // namespace desmo
