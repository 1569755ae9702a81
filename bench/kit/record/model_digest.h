#pragma once

#include <string>

#include "formulations/model/model.h"

namespace desmo::bench {

/// Tells one model from another: SHA-256 of all that its solution depends on. These are entities
/// (kind, what they belong to, fixed values, initial estimate), constraints (name of the kind,
/// operands, constants, rows left out), groups and their order, and the drivers' motions. What only
/// people read, the names of entities, constraints, groups and bodies, does not count.
///
/// Values are rounded to 9 decimals of their unit, no coarser than what a formulation may differ
/// from the reference, so that the last bit of a sine, which is the compiler's and the C library's
/// choice, makes no other model of it.
std::string model_digest(const Model& model);

}  // namespace desmo::bench
