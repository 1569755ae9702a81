#pragma once

#include <memory>
#include <string_view>

#include "bench/kit/candidate_name.h"
#include "bench/kit/delivery.h"
#include "bench/kit/problem.h"
#include "formulations/base/output_writer.h"
#include "formulations/formulation.h"
#include "formulations/id.h"

namespace desmo::regression {

/// Returns a case at one size, in the coordinates of the id, over its first instants, 10 ms apart,
/// without a reference. Throws std::invalid_argument when this build has no such case, size or
/// formulation.
bench::Problem problem_of(const bench::CandidateName& name, int instants);

/// A formulation ready to be run, or stepped through, while its instructions are counted or its
/// time is taken. It is no bench::Candidate: that would link the quadruple reference into the
/// counted program, with copies of templates that are compiled with little optimisation.
class SteppedFormulation {
 public:
  /// problem: outlives this. others: settings that the id does not name. Throws
  /// std::invalid_argument when this build has no such formulation.
  SteppedFormulation(const bench::Problem& problem, std::string_view id,
                     const Settings& others = {});

  /// Runs through the motion: first assembly, all steps, and the delivery of every instant.
  Summary run() { return formulation_->run(grid, {}, delivery_); }

  /// Solves and delivers the instants from `first` to `last`, by a step each, forwards or
  /// backwards, up to the first that fails. The solution before the first step must be near.
  /// Returns the summary of the last step tried.
  Summary walk(int first, int last);

  /// Returns whether run() does not solve one instant after the other, because the settings ask for
  /// segments, threads or a stride. walk() always does.
  bool runs_at_once() const {
    return settings().segments > 1 || settings().threads > 1 || settings().stride > 1;
  }

  const Settings& settings() const { return configuration_.settings; }
  Formulation& formulation() { return *formulation_; }
  Observer& delivery() { return delivery_; }

  const TimeGrid grid;

 private:
  Configuration configuration_;
  std::unique_ptr<Formulation> formulation_;
  const OutputWriter output_;
  bench::Delivery delivery_;
};

/// Returns the number of further steps that make the work of `steps` larger by `percent`, rounded.
int extra_steps(int steps, double percent);

}  // namespace desmo::regression
