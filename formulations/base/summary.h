#pragma once

namespace desmo {

/// Outcome of solving an instant.
enum class Status {
  solved,
  not_converged,  ///< the tolerance was not met in the iterations allowed
  singular,       ///< Φ_φ could not be factorised
  not_finite,     ///< Φ is not a finite number
};

/// The content of every summary. It has no verdict: each kind of summary has one of its own.
struct BasicSummary {
  Status status = Status::solved;
  long instants = 0;    ///< number of instants solved or interpolated
  long iterations = 0;  ///< Newton iterations of the slowest part, summed over instants
  /// Updates of single unknowns by Newton's method: unknowns times iterations, summed over parts
  /// and instants. A measure of work.
  long updates = 0;
  long sub_steps = 0;  ///< sub-steps tried, where a step could not be solved at once
  /// Largest accepted ‖Φ‖₂ of the whole mechanism or, on failure, the one that failed; relative,
  /// like the tolerance.
  double residual = 0;
  int group = -1;  ///< on failure, the position in Model::groups of the one not solved, if known
  int constraint = -1;   ///< on failure, that of the constraint most concerned, if known
  double time = 0;       ///< time of the last instant tried [s]; stopped in segments: unspecified
  bool stopped = false;  ///< the observer ended the run

  /// Adds the summary of the next instant. If that failed, takes over its status, group, constraint
  /// and residual.
  void add(const BasicSummary& instant);
};

/// Outcome of a step or of a whole run:
///
///   const Summary summary = formulation->step(0.01);
///   if (!summary.ok()) std::puts(describe(summary, model).c_str());
struct [[nodiscard]] Summary : BasicSummary {
  bool ok() const { return status == Status::solved; }
};

}  // namespace desmo
