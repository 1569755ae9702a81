// The task of `desmo solve`.
#pragma once

#include <optional>
#include <string>

#include "bench/cli/input.h"
#include "bench/cli/own_code.h"
#include "bench/cli/solve/series.h"
#include "cases/io/new_files.h"
#include "formulations/formulation.h"
#include "formulations/model/plan.h"
#include "formulations/verification/run/checked_run.h"

namespace desmo::cli {

struct SolveOptions {
  std::string scene, output, formulation, drivers;
  std::optional<SeriesFormat> format;
  UnitSystem units = UnitSystem::file;
  bool explain = false, quiet = false, flags = false;
  CheckOptions check;
  GenerationOptions own_code;
};

/// A task of `desmo solve`: the input, how it is solved, and where the answers go.
struct Task {
  const SolveOptions& options;
  const Input& input;
  const Configuration& chosen;
  const Model& whole;  ///< the model of the scene
  const Plan& plan;    ///< the part of `whole` that is solved
  Measures& measures;  ///< measures that have columns
  const SeriesHeading& heading;
  OutputFile& output;
  bool named;  ///< the formulation is the user's choice, not the program's
};

/// Answers each row of --drivers at once, with its outcome. Throws what DriverRows and OutputFile
/// throw, and CommandError: usage_error for a formulation or --check that rows cannot have;
/// not_solved at the first row that fails or, with --strict, is flagged. With --past-failures,
/// names such rows on standard error instead, unless quiet.
void solve_rows(const Task& task, Formulation& formulation);

}  // namespace desmo::cli
