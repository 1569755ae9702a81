#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bench/experiments/accuracy/problem.h"
#include "formulations/formulation.h"
#include "formulations/id.h"
#include "formulations/verification/error.h"

namespace desmo::accuracy {

/// One formulation with its settings, tried on a problem: how wrong it is, and what a step costs.
class Trial {
 public:
  enum class State {
    untried,
    solved,          ///< it has an error and may be timed
    failed,          ///< in the motion; the message says where
    not_applicable,  ///< the formulation does not offer the settings; the message says why
  };

  /// The problem must outlive the trial.
  Trial(const Problem& problem, const Configuration& configuration);

  std::string id() const { return id_with(*configuration_.variant, configuration_.settings); }
  const Configuration& configuration() const { return configuration_; }

  /// Solves the whole motion and compares it with the reference.
  void compare();
  /// Takes one more sample of the CPU time of a step: the whole motion with its assembly, drivers
  /// and delivery into plain vectors, by the number of instants delivered; over and over until that
  /// took `least` seconds. Needs State::solved.
  void time(double least);

  State state = State::untried;
  std::string message;
  Error error;                           ///< of the outputs asked for
  Error violation;                       ///< of the equations, at a few of the instants compared
  double iterations_per_step = 0;        ///< by the number of instants, as times are
  std::vector<double> seconds_per_step;  ///< samples

  /// The least of the samples; infinite when there is none.
  double min_seconds() const;

 private:
  void stop(State reached, std::string why);

  const Problem& problem_;
  Configuration configuration_;
  std::unique_ptr<Formulation> formulation_;
};

}  // namespace desmo::accuracy
