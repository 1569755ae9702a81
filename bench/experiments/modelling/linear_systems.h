#pragma once

#include "formulations/model/model.h"
#include "formulations/model/partition.h"

namespace desmo::modelling {

/// Sizes of the linear systems of a step, summed over the parts of a partition that move.
struct LinearSystems {
  int unknowns = 0;      ///< unknowns of the systems, to which derived ones do not belong
  int entries = 0;       ///< entries of the matrices, after condensation
  int condensation = 0;  ///< multiplications and additions of one factorisation (see Condensed)
};

/// Returns the sizes of a model's linear systems.
LinearSystems linear_systems(const Model& model, Partition partition);

/// Returns the condition number of a model at the first instant of its motion (see
/// ConditionNumber): of all its equations, derivations among them. Throws std::runtime_error where
/// it cannot be assembled.
double condition_at_start(const Model& model, double time);

}  // namespace desmo::modelling
