#pragma once

#include <vector>

#include "cases/mechanism/motion.h"
#include "formulations/base/reference_instant.h"
#include "formulations/model/model.h"

namespace desmo::size {

/// A mechanism to be solved in many ways over the same motion, and what is right.
struct Problem {
  Model model;
  TimeGrid grid;
  double tolerance;
  std::vector<ReferenceInstant> reference;  ///< at the first, the middle and the last instant
  /// Where that is from: "quadruple", two solutions in quadruple precision, which agree; "double",
  /// where these would take minutes: one in double precision, by code of its own as well.
  const char* checked_against;
};

/// grid: of three instants or more. Throws what make_reference throws, and see
/// bench::require_agreement.
Problem make_problem(Model model, const TimeGrid& grid, double tolerance);

/// What finding `least` unknowns or more of a mechanism takes, and no more than it must: what the
/// first of its entities need, of all of them if it has fewer.
Model cut_to(const Model& whole, int least);

}  // namespace desmo::size
