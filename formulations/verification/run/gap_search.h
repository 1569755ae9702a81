#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "formulations/formulation.h"
#include "formulations/verification/run/checked_run.h"

namespace desmo {

/// Returns the assembly error at a time [s] at which a formulation failed (find_assembly_error()).
/// The search begins at the formulation's positions.
std::optional<Misfit> assembly_error_at(const Formulation& formulation, double time);

/// Finds the ends of a gap. Times count as solved if positions meet default_tolerance. Returns the
/// gap with the index of the first grid instant after it; the number of instants if none is. Leaves
/// the formulation at a position near the gap's end; if the grid ends first, its positions are
/// unspecified.
/// - failed: index of the grid instant that could not be assembled
/// - failure: summary of the run, which ended there
/// - solves: returns whether an instant is solved otherwise than by assembly, and then leads the
///   formulation there. It is asked of each instant of the gap, in turn.
std::pair<Gap, int> find_gap(Formulation& formulation, const TimeGrid& grid, int failed,
                             const CheckedSummary& failure, const std::function<bool(int)>& solves);

}  // namespace desmo
