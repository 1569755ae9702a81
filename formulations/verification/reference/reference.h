#pragma once

#include <span>
#include <vector>

#include "formulations/base/per_level.h"
#include "formulations/base/reference_instant.h"
#include "formulations/model/model.h"
#include "formulations/model/scales.h"

namespace desmo {

/// Precision of a reference solution: double (53 bits), or quadruple (113 bits).
enum class Precision { standard, quadruple };

/// Returns positions, velocities and accelerations at ascending times [s], solved group by group.
/// The code shares with the formulations only the constraint kinds, the motions and the list of
/// parts. It uses Newton's method with dense matrices and pivoting, in steps of at most 10 ms. They
/// begin at an assembly at times.front(), on the drawn branch if DrawnStart finds it. With
/// quadruple precision each instant is solved again in that precision, and has remainders.
/// Iterations end when only rounding is left (StoppingRule). Throws std::runtime_error, naming the
/// group and the instant, when one does not converge.
std::vector<ReferenceInstant> reference_solution(const Model& model, std::span<const double> times,
                                                 Precision precision);

/// A motion solved twice in quadruple precision.
struct Reference {
  std::vector<ReferenceInstant> instants;  ///< the solution group by group
  Scales scales;                           ///< scales of the motion
  /// Largest difference of the two solutions over all outputs and instants, relative to the scales,
  /// taken before rounding to double. Measured errors below it mean nothing. It is about 1e-25 for
  /// a well-conditioned model; with floor > 1e-20 the solution is no reference.
  PerLevel<double> floor;
};

/// Solves a motion twice in quadruple precision: with reference_solution(), and likewise with all
/// equations at once (GlobalSolver). The second refines sparse factors in doubles, and finds rates
/// from the residuals alone, by jets. The two share only the constraint kinds' residuals, the
/// motions, and how an instant is set, read and corrected (ReferenceSolver). They also share the
/// rules for steps and for the end of iterations (DrawnStart, StoppingRule). An error in the
/// partition, in a derivative or in an elimination, or a wrong branch in one of them, shows in
/// `floor`. Throws std::runtime_error, naming the instant, when either does not converge.
/// ErrorMeasure (error.h) compares a run with it:
///
///   const Reference reference = make_reference(model, times);
///   ErrorMeasure measure(model, reference.instants, reference.scales);
///   if (!formulation->run(grid, {}, measure).ok()) return;
///   std::printf("errors of positions: %.1e\n", measure.error().position.max);
Reference make_reference(const Model& model, std::span<const double> times);

}  // namespace desmo
