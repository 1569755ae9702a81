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

/// A motion that candidates solve, and the reference with which they are compared.
struct Problem {
  Plan plan;  ///< the part of the model that is solved; no outputs or levels: everything
  TimeGrid grid;
  Reference reference = {};  ///< right answers at instants of the grid; empty: shared_reference()
  double tolerance = Settings{}.tolerance;  ///< that of the candidates' settings
  /// The origin of the reference. "quadruple": two solutions in quadruple precision, which agree.
  /// "double": one in double precision, by code that no formulation uses, where the two would take
  /// minutes.
  const char* checked_against = "quadruple";
  /// Returns why a formulation is not to be run; empty: it is to be run. Without this function all
  /// formulations are run.
  std::function<std::string(const Configuration&)> missing{};
  KernelTable kernels{};  ///< generated code, in addition to what desmo was built with
  /// The coordinates that are delivered; empty: all. Without `compared`, the reference must have
  /// the same ones in the same order.
  std::vector<int> delivered{};
  /// The values that are compared; empty: all that is delivered.
  std::vector<Compared> compared{};
  /// Differences are divided by the scales of the motion (coordinate_scales()), so that the unit of
  /// length may be any. Else they are absolute.
  bool is_relative = false;
  std::optional<Model> whole{};  ///< model whose motion the reference is; nothing: that of the plan
  std::string case_name{};       ///< <case> in names of benchmarks; empty: the mechanism's name

  /// Returns the highest level that is solved.
  Level level() const { return plan.outputs.empty() ? Level::acceleration : plan.level(); }
};

/// Returns the problem of a plan, with a reference at `compared` instants, 2 or more, at irregular
/// distances all over the grid (spread_times()); at all instants if there are no more. Throws what
/// make_reference throws.
Problem make_problem(Plan plan, const TimeGrid& grid, int compared);

/// Returns the problem of a whole model, with a reference at the first, the middle and the last
/// instant. Throws what make_reference and require_agreement throw.
Problem make_problem(Model model, const TimeGrid& grid, double tolerance);

/// Returns the number of coordinates to be found at every instant, which are neither driven nor at
/// rest.
int moving_unknowns(const Model& model);

}  // namespace desmo::bench
