#include <algorithm>
#include <utility>

#include "cases/io/readers.h"

namespace desmo {
namespace {

using Coordinate = Mechanism::Coordinate;
using Coupling = Mechanism::Coupling;

/// Converts the factors of a sum from coordinates in the file's units to those in SI units, up to a
/// common factor. They change only where the sum mixes lengths and angles.
void convert(Coupling& coupling, const std::vector<Coordinate>& coordinates,
             const DisplayUnits& units) {
  const auto turns = [&](const Coupling::Term& term) {
    return coordinates[term.coordinate].is_angle();
  };
  const auto angles = std::ranges::count_if(coupling.terms, turns);
  if (angles == 0 || angles == std::ssize(coupling.terms)) return;
  const Derived ratio = Derived(units.length.in_si) / exact_size(units.angle);
  for (Coupling::Term& term : coupling.terms)
    if (turns(term)) term.factor = term.factor * ratio;
}

Coupling by_table(const JsonValue& value, const std::vector<Coordinate>& coordinates,
                  const DisplayUnits& units, const Names& names, NamedFiles& files) {
  value.allow({"coordinate", "of", "at", "values", "file", "ends", "from"});
  const int follows = names.coordinates.find(value["coordinate"]),
            leads = names.coordinates.find(value["of"]);
  TableColumn values = column_of("values", coordinates[follows], units),
              arguments = column_of("at", coordinates[leads], units);
  const DisplayUnit unit = values.unit;  // that of `from`; a heading may change values.unit
  read_table(value, files, coordinates, arguments, values);
  Coupling coupling;
  for (const auto& [c, column] : {std::pair(follows, &values), std::pair(leads, &arguments)})
    coupling.terms.push_back({c, Derived(1) / exact_size(column->unit)});
  Coupling::Table& table = coupling.table.emplace();
  table.arguments = std::move(arguments.numbers);
  table.values = std::move(values.numbers);
  table.ends = read_ends(value, true);
  if (const auto from = value.find("from")) table.from = read_from(*from, unit);
  return coupling;
}

Coupling of_sum(const JsonValue& value, const std::vector<Coordinate>& coordinates,
                const DisplayUnits& units, const Names& names) {
  if (!value.find("sum")) value.allow({"sum", "coordinate", "of", "at", "values"});
  value.allow({"sum"});
  Coupling coupling;
  value["sum"].require_object(R"({"a": 20, "b": 40})");
  for (const JsonValue& factor : value["sum"].members())
    coupling.terms.push_back(
        {names.coordinates.find(factor, factor.key()), Derived(factor.number())});
  convert(coupling, coordinates, units);
  return coupling;
}

}  // namespace

std::vector<Coupling> read_couplings(const JsonValue& root, const Mechanism& mechanism,
                                     const DisplayUnits& units, const Names& names,
                                     NamedFiles& files) {
  std::vector<Coupling> couplings;
  if (const auto list = root.find("couplings"))
    for (const JsonValue& value : list->members()) {
      const std::string name = checked_name(value, value.key());
      const bool has_table = value.find("coordinate") || value.find("of");
      couplings.push_back(has_table ? by_table(value, mechanism.coordinates, units, names, files)
                                    : of_sum(value, mechanism.coordinates, units, names));
      couplings.back().name = name;
    }
  return couplings;
}

}  // namespace desmo
