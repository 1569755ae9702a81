#pragma once

#include <optional>
#include <vector>

#include "formulations/model/model.h"

namespace desmo {

/// Powers of the unit of length in the dimensions and the equations of a constraint. Both are 2 for
/// ‖b − a‖² − L² = 0, whose dimension is L². The equation p − a − c v = 0 has power 1.
struct LengthPowers {
  std::vector<int> constants, rows;
};

/// Finds the powers by trial evaluations. Returns nothing where an equation mixes powers.
std::optional<LengthPowers> length_powers(const Model& model, const Constraint& constraint);

}  // namespace desmo
