#pragma once

#include <span>
#include <vector>

#include "formulations/base/per_level.h"
#include "formulations/base/reference_instant.h"
#include "formulations/model/model.h"
#include "formulations/scaling/scales.h"

namespace desmo {

enum class Precision { standard, quadruple };

/// Positions, velocities and accelerations at ascending instants, found group by group with code
/// that shares with the formulations only the constraint kinds, the motions and the list of parts:
/// dense matrices, pivoting, Newton's method, steps of at most 10 ms from an assembly at
/// times.front(). With quadruple precision, each instant is then solved again in that precision,
/// and has rests. Solved as far as the precision allows, whatever the units. Throws
/// std::runtime_error, naming the group and the instant, when it does not converge.
std::vector<ReferenceInstant> reference_solution(const Model& model, std::span<const double> times,
                                                 Precision precision);

/// A motion solved twice in quadruple precision.
struct Reference {
  std::vector<ReferenceInstant> instants;  ///< found group by group
  Scales scales;                           ///< of the motion
  /// Largest difference of the two solutions over all outputs and instants, relative to the scales,
  /// taken before anything is rounded. No error below it means anything. The numbers of a
  /// well-conditioned mechanism agree to 1e-25; what differs by more than 1e-20 is no reference.
  PerLevel<double> floor;
};

/// Solves a motion twice in quadruple precision: as reference_solution does, and once more from the
/// mechanism's estimate on, all equations at once, by a sparse factorisation, with velocities and
/// accelerations from nothing but the residuals (jets). What the two share is the constraint kinds'
/// residuals and the motions; an error of the partition, of a derivative, of an elimination or a
/// branch taken by one of them shows as their difference, `floor`. Throws std::runtime_error,
/// naming the instant, when either does not converge.
Reference make_reference(const Model& model, std::span<const double> times);

}  // namespace desmo
