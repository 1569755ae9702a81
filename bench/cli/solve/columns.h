// Columns that `desmo solve` writes for each instant.
#pragma once

#include <string>
#include <vector>

#include "bench/cli/input.h"
#include "bench/cli/units.h"
#include "bench/kit/delivery.h"
#include "formulations/model/plan.h"
#include "formulations/modelling/measures/measures.h"

namespace desmo::cli {

/// A column: one number for each instant.
struct Column {
  std::string name;  ///< "C.x", "d/dt C.x", "d2/dt2 C.x"
  /// "mm", "mm/s", "mm/s^2"; "deg", …; "-" for unit vectors; "1" for lengths of a free unit.
  DisplayUnit unit;
  Level level;
  int order = 0;          ///< order of the time derivative that the name stands for: 0, 1 or 2
  int coordinate = -1;    ///< index in q, q̇ or q̈ (measures follow coordinates); -1: a constant
  double constant = 0;    ///< value of a constant column, in SI units
  bool may_lack = false;  ///< numbers may be missing (NaN), such as a ratio of rates at rest

  /// Returns the value in the column's unit.
  double value(const Instant& instant) const {
    return unit.from_si(coordinate < 0 ? constant : bench::values_at(instant, level)[coordinate]);
  }
  std::string heading() const { return name + " [" + unit.name + "]"; }
};

/// Returns the columns of an entity up to a level.
std::vector<Column> columns_of(const Model& model, const Output& output, const DisplayUnits& units);

/// Returns the columns of measures. coordinates: number of coordinates before them in an instant.
std::vector<Column> columns_of(const Measures& measures, int coordinates,
                               const DisplayUnits& units);

/// Returns the columns of entities in the order asked for, then those of the measures. An entity
/// has positions, velocities and accelerations up to the level asked for. Where everything is asked
/// for, what never moves is left out. Throws InputError, naming the source, where two columns have
/// one heading.
std::vector<Column> make_columns(const Plan& plan, const Measures& measures, const Input& input);

}  // namespace desmo::cli
