#pragma once

#include "cases/mechanism/motion.h"
#include "formulations/equations/kernel_table.h"
#include "formulations/planning/plan.h"
#include "formulations/verification/reference/reference.h"

namespace desmo::accuracy {

/// A motion to be solved in many ways, and what is right.
struct Problem {
  Plan plan;
  TimeGrid grid;
  Reference reference;    ///< at instants all over the grid, the first and the last among them
  KernelTable kernels{};  ///< of what formulations are made
};

/// compared: instants of the reference, at least 2; all of the grid when it has no more. Throws
/// what make_reference throws.
Problem make_problem(Plan plan, const TimeGrid& grid, int compared);

/// A motion for which settings are chosen.
struct TunedMotion {
  Problem whole;
  Problem begin;  ///< its first hundred instants, on which everything is tried
};

/// Throws what make_reference throws.
TunedMotion make_tuned_motion(const Plan& plan, const TimeGrid& grid);

}  // namespace desmo::accuracy
