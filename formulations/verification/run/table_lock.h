#pragma once

#include <optional>
#include <span>

#include "formulations/model/model.h"

namespace desmo {

/// A position in which the value of a table is driven beyond an extremum of the table, so that its
/// argument cannot go on.
struct TableLock {
  EntityId argument;  ///< coordinate that is the argument of the table
  double at;          ///< its last proven value [unit of length] or [rad], near the extremum
};

/// Returns the lock of a motion that a formulation led outside of a table (Status::not_finite).
/// Returns nothing if an end of the table is nearer than an extremum, or the constraint has no
/// table. A table that repeats has no end.
/// - constraint: BasicSummary::constraint
/// - followed_to: positions up to which the motion was proven; may be empty
std::optional<TableLock> find_table_lock(const Model& model, int constraint,
                                         std::span<const double> followed_to);

}  // namespace desmo
