#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "formulations/base/reference_instant.h"
#include "formulations/model/model.h"
#include "formulations/model/scales.h"
#include "tests/properties/continuation.h"

namespace desmo::properties {

/// True answer at an instant of a grid.
struct TrueInstant {
  ReferenceInstant instant;  ///< no q: none is known, or it is singular
  double condition = INFINITY;
  double path_condition = INFINITY;  ///< largest since the instant before, both included
};

/// Right answers of a scene: those of the numbers in the file, in quadruple precision.
struct Truth {
  /// (instants) No q: there is no position, or it is singular in double precision.
  std::vector<TrueInstant> instants;
  /// (instants) Whether the way from the drawing to here is well-conditioned.
  std::vector<bool> regular;
  /// (instants) Whether all mechanisms that round to the file go the same way to here.
  std::vector<bool> decided;
  Scales scales;          ///< scales of the answers
  double far = 1;         ///< largest coordinate over the mechanism's size, at least 1
  double size_ratio = 1;  ///< largest coordinate or length over the least length, at least 1
};

/// κ below which every instant is to be proven.
inline constexpr double well_conditioned = 1e6;

/// κ of a way from which on roundings of the file decide which branch it takes: κ² u reaches 0.01.
/// Branches that cross in the mechanism that was meant then pass each other in that of the file,
/// some 10⁻¹⁶ apart. Where they do cross, κ is above `crossing`, and the answer goes smoothly on.
inline constexpr double undecided = 1e7, crossing = 1e11;

/// Follows the drawing to the first instant of the grid and through the others, smoothly past
/// singular positions. Throws std::runtime_error where the drawing means no position.
Truth true_answers(const Model& model, const TimeGrid& grid);

bool has_answer(const TrueInstant& instant);

/// Returns the exact instant to which positions lead by themselves, on whatever branch.
TrueInstant answer_near(const Model& model, double time, std::span<const double> q);

/// Returns the largest misfit of an equation that was left out, |Φ| over its steepest slope, over
/// the mechanism's size. of_all: of any equation.
double largest_misfit(const Model& model, std::span<const double> q, bool of_all = false);

/// Returns the error that an answer itself may have, of each coordinate's scale.
PerLevel<double> floor_of(const Truth& truth, const TrueInstant& instant);

}  // namespace desmo::properties
