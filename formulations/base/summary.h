#pragma once

#include <string>

#include "formulations/model/model.h"

namespace desmo {

enum class Status {
  converged,
  not_converged,  ///< the tolerance was not met in the iterations allowed
  singular,       ///< Φ_φ could not be factorised
  not_finite,     ///< Φ is not a finite number
};

/// The outcome of a step, or of a whole run:
///
///   const Summary summary = formulation->step(0.01);
///   if (!summary.ok()) std::puts(describe(summary, model).c_str());
struct Summary {
  Status status = Status::converged;
  long instants = 0;    ///< solved, or interpolated between those solved
  long iterations = 0;  ///< Newton iterations, the largest of any part, summed over instants
  /// Unknowns that Newton's method moved: of each part its number times its iterations, summed. The
  /// work of a motion grows with it.
  long updates = 0;
  long sub_steps = 0;  ///< tried where a step could not be solved at once
  /// Largest ‖Φ‖₂ of the whole mechanism accepted, or that which failed: relative, as the
  /// tolerance.
  double residual = 0;
  GroupId group = -1;    ///< on failure, the group that could not be solved (see find_culprit)
  int constraint = -1;   ///< on failure, the constraint most concerned
  double time = 0;       ///< of the last instant tried, s
  bool stopped = false;  ///< the observer ended the run
  bool ok() const { return status == Status::converged; }

  /// Adds what the next instant took. After a failure status, group, constraint and residual are
  /// those of the failure.
  void add(const Summary& instant);
};

/// Returns a sentence for people: the status and, on failure, group, constraint and time.
std::string describe(const Summary& summary, const Model& model);

}  // namespace desmo
