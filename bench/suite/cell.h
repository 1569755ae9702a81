#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/suite/options.h"
#include "bench/suite/phases.h"
#include "bench/suite/verification.h"
#include "cases/cases.h"
#include "formulations/variants.h"

namespace desmo::suite {

/// One case at one size with one formulation.
class Cell {
 public:
  enum class State { untouched, verified, failed, not_run };

  Cell(const Case& definition, int coordinates, const Variant& variant, const Options& options);

  /// <case>/<coordinates>/<id>
  std::string name() const;

  /// Builds the formulation and checks it over the whole motion against the reference; what goes
  /// wrong ends in message(). Done once.
  void verify(ReferenceCache& references);

  /// Measures where the time goes, at the size where that is shown. Needs verify().
  void profile();

  /// The whole analysis, as timed. Needs State::verified; a failure turns it into State::failed.
  Summary analyse();

  const Case& definition;
  const int coordinates;
  const Variant& variant;
  const TimeGrid grid;

  bool is_failed() const { return state == State::failed; }
  bool is_not_run() const { return state == State::not_run; }

  State state = State::untouched;
  std::string message;  ///< why it failed or was not run
  int groups = 0, degrees_of_freedom = 0;
  Errors errors;
  double setup_seconds = 0;  ///< CPU: analysis, ordering, allocation
  double iterations_per_step = 0, residual = 0;
  std::vector<double> cpu_seconds;  ///< one for each repetition
  std::optional<PhaseTimes> phases;

 private:
  void fail(std::string why);

  std::unique_ptr<Mechanism> mechanism_;  // the formulation refers to it
  std::unique_ptr<Formulation> formulation_;
  std::unique_ptr<Sink> delivery_;
};

/// Every cell of the suite, in the order of the tables. Dense global solves beyond the limit are
/// there too, as State::not_run, with the reason.
std::vector<std::unique_ptr<Cell>> make_cells(const Options& options);

}  // namespace desmo::suite
