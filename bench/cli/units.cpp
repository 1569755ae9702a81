#include "bench/cli/units.h"

#include "bench/cli/commands.h"
#include "cases/mechanism/formatted.h"

namespace desmo::cli {

void add_units(CLI::App& command, UnitSystem& units) {
  add_choice(command, "--units", units, {{"file", UnitSystem::file}, {"si", UnitSystem::si}},
             "Units of what is written and read: those of the scene or, where it names none, of "
             "the mechanism (file, the default); or metres and radians (si)");
}

DisplayUnit unit_of(const DisplayUnits& units, EntityKind kind, Level level) {
  static constexpr const char* per_time[] = {"", "/s", "/s^2"};
  const bool is_rate = level != Level::position;
  DisplayUnit unit = kind == EntityKind::vector  ? DisplayUnit{is_rate ? "1" : "-", 1}
                     : kind == EntityKind::angle ? units.angle
                                                 : units.length;
  unit.name += per_time[static_cast<int>(level)];
  return unit;
}

std::string quantity(double si, const DisplayUnit& unit, const char* format) {
  const double value = unit.from_si(si);
  return formatted(format, value == 0 ? 0 : value) + (unit.name == "1" ? "" : " " + unit.name);
}

}  // namespace desmo::cli
