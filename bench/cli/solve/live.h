// desmo solve --drivers: a scene whose drivers come row by row.
#pragma once

#include <string>

#include "bench/cli/solve/series.h"
#include "cases/io/new_files.h"
#include "formulations/formulation.h"
#include "formulations/model/plan.h"
#include "formulations/verification/run/check_options.h"

namespace desmo::cli {

struct LiveRequest {
  std::string source, drivers;  ///< of the scene, for messages; of the rows: a file or -
  const Model& whole;           ///< the model of the scene
  const Plan& plan;             ///< its part that is solved
  Measures& measures;           ///< of its columns
  const DisplayUnits& units;    ///< of rows, answers and messages
  CheckMode check;
  bool strict, past_failures, quiet;
};

/// Answers each row at once, with its outcome. Throws what DriverRows and OutputFile throw, and
/// CommandError (not_solved) at the first row that fails or, if strict, is flagged. With
/// past_failures, names them on standard error instead, unless quiet.
void solve_live(const LiveRequest& request, Formulation& formulation, const SeriesHeading& heading,
                OutputFile& output);

}  // namespace desmo::cli
