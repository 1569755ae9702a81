#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/kit/verification.h"
#include "cases/mechanism/motion.h"
#include "formulations/base/settings.h"
#include "formulations/equations/kernel_table.h"
#include "formulations/id.h"
#include "formulations/model/plan.h"
#include "formulations/verification/reference/reference.h"

namespace desmo::bench {

/// A motion that candidates solve, and what is right.
struct Problem {
  Plan plan;  ///< the part of the model that is solved; no outputs or levels: everything
  TimeGrid grid;
  Reference reference = {};  ///< at instants of the grid, the first and the last among them
  double tolerance = Settings{}.tolerance;
  /// The origin of the reference. "quadruple": two solutions in quadruple precision, which agree.
  /// "double": one in double precision, by code that no formulation uses, where the two would take
  /// minutes.
  const char* checked_against = "quadruple";
  /// Returns why a formulation is not to be run, empty: it is; no function: all are.
  std::function<std::string(const Configuration&)> missing{};
  KernelTable kernels{};  ///< generated code, apart from what desmo was built with
  /// The coordinates that are delivered and compared, in the order of the reference; empty: all.
  std::vector<int> delivered{};
  /// The values that are compared; empty: all that is delivered.
  std::vector<Compared> compared{};
  /// Differences are relative to the mechanism's size, speed and acceleration: its unit of length
  /// may be any.
  bool is_relative = false;
  std::optional<Model> whole{};  ///< the model whose motion is the reference's, unless the plan's
  std::string case_name{};       ///< <case> in names of benchmarks; empty: the mechanism's name

  Level level() const { return plan.outputs.empty() ? Level::acceleration : plan.level(); }
};

/// Returns what the plan keeps, compared at instants all over the grid, at least 2, in no regular
/// distances; all of the grid when it has no more. Throws what make_reference throws.
Problem make_problem(Plan plan, const TimeGrid& grid, int compared);

/// Returns a whole model, compared at the first, the middle and the last instant. Throws what
/// make_reference throws, and see require_agreement.
Problem make_problem(Model model, const TimeGrid& grid, double tolerance);

/// Returns the number of coordinates to be found at every instant: neither driven nor at rest.
int moving_unknowns(const Model& model);

}  // namespace desmo::bench
