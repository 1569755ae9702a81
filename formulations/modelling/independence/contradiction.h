#pragma once

#include <optional>
#include <string>
#include <vector>

#include "formulations/modelling/independence/linearisation.h"

namespace desmo {

/// A contradiction: equations of a group that cannot hold together once its drivers have moved.
struct Contradiction {
  int constraint;  ///< constraint with the largest residual at the least-squares position
  double amount;   ///< the residual: a length if the constraint has lengths, else a number or [rad]
  double moved;    ///< displacement of the drivers, in natural magnitudes
};

/// Moves a group's drivers a little from an assembled position, first forwards, then backwards.
/// Returns nullopt when all its candidates, dependent ones included, can follow in one direction.
std::optional<Contradiction> find_contradiction(const Model& model, const GroupSystem& system,
                                                const std::vector<double>& position,
                                                Lineariser& lineariser);

}  // namespace desmo
