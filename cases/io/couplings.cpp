#include <algorithm>

#include "cases/io/readers.h"

namespace desmo {
namespace {

using Coordinate = Mechanism::Coordinate;
using Coupling = Mechanism::Coupling;

/// Converts factors to SI units. Lengths count as the doubles nearest to them.
void convert(Coupling& coupling, const std::vector<Coordinate>& coordinates,
             const DisplayUnits& units) {
  const auto is_angle = [&](const Coupling::Term& term) {
    return coordinates[term.coordinate].type == Mechanism::CoordinateType::angle;
  };
  const auto angles = std::ranges::count_if(coupling.terms, is_angle);
  if (angles == 0 || angles == std::ssize(coupling.terms)) return;
  const Derived degree = Derived::pi() / 180;
  const Derived ratio =
      Derived(units.length.in_si) / (units.angle.in_si == 1 ? Derived(1) : degree);
  for (Coupling::Term& term : coupling.terms)
    if (is_angle(term)) term.factor = term.factor * ratio;
}

}  // namespace

std::vector<Coupling> read_couplings(const JsonValue& root,
                                     const std::vector<Coordinate>& coordinates,
                                     const DisplayUnits& units, const Names& names) {
  std::vector<Coupling> couplings;
  if (const auto list = root.find("couplings"))
    for (const JsonValue& value : list->members()) {
      Coupling& coupling = couplings.emplace_back();
      coupling.name = checked_name(value, value.key());
      value.allow({"sum"});
      for (const JsonValue& factor : value["sum"].members())
        coupling.terms.push_back(
            {names.coordinates.find(factor, factor.key()), Derived(factor.number())});
      convert(coupling, coordinates, units);
    }
  return couplings;
}

}  // namespace desmo
