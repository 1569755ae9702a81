#pragma once

namespace desmo {

/// Outcome of solving an instant.
enum class Status {
  solved,
  not_converged,  ///< the tolerance was not met in the iterations allowed
  singular,       ///< Φ_φ could not be factorised
  not_finite,     ///< ‖Φ‖₂ is not a finite number
};

/// Members that all kinds of summaries have in common. Each kind has its own verdict, such as
/// Summary::ok().
struct BasicSummary {
  Status status = Status::solved;
  long instants = 0;    ///< number of instants solved or interpolated
  long iterations = 0;  ///< Newton iterations of the slowest part, summed over instants
  /// Updates of single unknowns by Newton's method: unknowns times iterations, summed over parts
  /// and instants. A measure of work.
  long updates = 0;
  long sub_steps = 0;  ///< sub-steps tried, where a step could not be solved at once
  /// Largest accepted ‖Φ‖₂ of the whole mechanism, relative like Settings::tolerance. On failure,
  /// ‖Φ‖₂ of the parts up to the failed one at the failed instant; NaN where none was evaluated.
  double residual = 0;
  int group = -1;  ///< on failure, position in Model::groups of the group not solved; -1: unknown
  /// On failure, position of a constraint of that group; -1: unknown. It is the one with the
  /// largest residual or, where Φ_φ is singular, the one most involved in the dependence.
  int constraint = -1;
  double time = 0;  ///< time of the last instant tried [s]; unspecified after a stop in segments
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
