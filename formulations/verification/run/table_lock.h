#pragma once

#include <optional>
#include <span>

#include "formulations/model/model.h"

namespace desmo {

/// A position in which a coordinate that follows a table cannot go on as it is driven, since the
/// table has an extremum there.
struct TableLock {
  EntityId argument;  ///< coordinate that the table is read at
  double at;          ///< its value [unit of length] or [rad]
};

/// Returns the lock of a motion that a formulation led outside of a table (Status::not_finite,
/// Summary::constraint); nothing where an end of the table is nearer than an extremum, or no table
/// is concerned.
/// - followed_to: the positions up to which the motion was proven; may be empty
std::optional<TableLock> find_table_lock(const Model& model, int constraint,
                                         std::span<const double> followed_to);

}  // namespace desmo
