#pragma once

#include <optional>
#include <vector>

#include "formulations/model/model.h"

namespace desmo {

/// With which powers of the unit of length the dimensions and the equations of a constraint go: of
/// ‖b − a‖² − L² = 0 the second, L² being its dimension, of p − a − c v = 0 the first.
struct LengthPowers {
  std::vector<int> constants, rows;
};

/// Found by trial, with numbers without a pattern. Nothing where equations mix powers.
std::optional<LengthPowers> length_powers(const Model& model, const Constraint& constraint);

}  // namespace desmo
