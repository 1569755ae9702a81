#pragma once

#include <optional>
#include <string>
#include <vector>

#include "formulations/modelling/independence/linearisation.h"

namespace desmo {

/// Equations of a group that cannot hold together once its drivers have moved a little.
struct Contradiction {
  int constraint;  ///< satisfied worst where all are satisfied best
  double amount;   ///< by which it is off: a length where it joins any, else a number or rad
  double moved;    ///< what its drivers were moved by, of their natural magnitudes
};

/// Whether all candidates of a group, those that look dependent included, can follow its drivers
/// from an assembled position; the best position is that of least squares.
std::optional<Contradiction> find_contradiction(const Model& model, const GroupSystem& system,
                                                const std::vector<double>& position,
                                                Lineariser& lineariser);

}  // namespace desmo
