#pragma once

#include <functional>
#include <optional>

#include "formulations/formulation.h"
#include "formulations/verification/run/checked_run.h"

namespace desmo {

/// Returns the assembly error at a time [s] at which a formulation could not be assembled. The
/// search begins at the formulation's positions.
std::optional<Misfit> assembly_error_at(const Formulation& formulation, double time);

/// A gap and the first grid instant after it, or the number of instants.
struct FoundGap {
  Gap gap;
  int next;
};

/// Finds the ends of a gap. Leaves the formulation at a position near the gap's end. Where the grid
/// ends first, its positions are unspecified.
/// - failed: the grid instant that could not be assembled
/// - failure: the summary of the run, which ended there
/// - solves: whether an instant is solved otherwise than by assembly. If it is, this has led the
///   formulation there. It is asked of each instant of the gap, in turn.
FoundGap find_gap(Formulation& formulation, const TimeGrid& grid, int failed,
                  const CheckedSummary& failure, const std::function<bool(int)>& solves);

}  // namespace desmo
