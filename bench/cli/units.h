// Units of what the commands write. The numbers inside are in SI units; each is converted once,
// where it is written or read.
//
//   const DisplayUnit unit = unit_of(input.units, EntityKind::point, Level::velocity);
//   text += quantity(speed, unit);  // "12.5 mm/s"
//
// Input::units are the scene's, or the mechanism's where the scene names none, or SI's with
// `--units si` (load_scene). See also Column::unit in solve/columns.h.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "cases/io/units.h"
#include "cases/mechanism/level.h"
#include "formulations/model/model.h"

namespace desmo::cli {

/// Units in which a command writes and reads.
enum class UnitSystem {
  file,  ///< the scene's, or the mechanism's
  si,
};

/// Adds the option --units, which sets `units`; it must outlive the command.
void add_units(CLI::App& command, UnitSystem& units);

/// Returns the unit of an entity's components, or of their rates. Unit vectors have "-" at position
/// level. Lengths have "1" where the unit of length is free.
DisplayUnit unit_of(const DisplayUnits& units, EntityKind kind, Level level = Level::position);

/// Returns an SI value in a unit, with the unit's name: "12.5 mm". Leaves out the name "1".
std::string quantity(double si, const DisplayUnit& unit, const char* format = "%.12g");

}  // namespace desmo::cli
