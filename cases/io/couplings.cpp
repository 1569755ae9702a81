#include <algorithm>
#include <array>

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

/// Returns the factor that takes a coordinate to the unit of the file.
Derived in_file_units(const Coordinate& c, const DisplayUnits& units) {
  if (c.type != Mechanism::CoordinateType::angle) return Derived(1) / units.length.in_si;
  return units.angle.in_si == 1 ? Derived(1) : Derived(180) / Derived::pi();
}

void read_by_table(const JsonValue& value, const std::vector<Coordinate>& coordinates,
                   const DisplayUnits& units, const Names& names, NamedFiles& files,
                   Coupling& coupling) {
  value.allow({"coordinate", "of", "at", "values", "file", "ends", "from"});
  const auto column = [&](std::string_view key, std::string_view coordinate) {
    const JsonValue name = value[coordinate];
    const int c = names.coordinates.find(name);
    coupling.terms.push_back({c, in_file_units(coordinates[c], units)});
    const bool is_angle = coordinates[c].type == Mechanism::CoordinateType::angle;
    const DisplayUnit& unit = is_angle ? units.angle : units.length;
    return TableColumn{key, coordinates[c].name, unit,
                       is_angle ? known_angle_units() : known_length_units(), unit.in_si};
  };
  const TableColumn values = column("values", "coordinate"), arguments = column("at", "of");
  Table table = read_table(value, files, arguments, values);
  coupling.table = {std::move(table.arguments), std::move(table.values), read_ends(value, true)};
  const auto from = value.find("from");
  if (!from) return;
  if (from->is_number()) {
    coupling.table->from = Derived(from->number()) / coupling.terms.front().factor;
  } else {
    constexpr std::array<std::string_view, 1> starts{"drawing"};
    from->choose("start", starts);
    coupling.table->from.reset();
  }
}

}  // namespace

std::vector<Coupling> read_couplings(const JsonValue& root, const Mechanism& mechanism,
                                     const DisplayUnits& units, const Names& names,
                                     NamedFiles& files) {
  std::vector<Coupling> couplings;
  if (const auto list = root.find("couplings"))
    for (const JsonValue& value : list->members()) {
      Coupling& coupling = couplings.emplace_back();
      coupling.name = checked_name(value, value.key());
      if (value.find("coordinate")) {
        read_by_table(value, mechanism.coordinates, units, names, files, coupling);
        continue;
      }
      value.allow({"sum"});
      for (const JsonValue& factor : value["sum"].members())
        coupling.terms.push_back(
            {names.coordinates.find(factor, factor.key()), Derived(factor.number())});
      convert(coupling, mechanism.coordinates, units);
    }
  return couplings;
}

}  // namespace desmo
