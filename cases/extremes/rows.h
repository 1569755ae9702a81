#pragma once

#include <vector>

#include "cases/extremes.h"

/// The cases of the rows of the table, one .cpp each.
namespace desmo::extreme {

std::vector<ExtremeCase> long_chains(Extent extent);
std::vector<ExtremeCase> near_dead_points(Extent extent);
std::vector<ExtremeCase> singular_positions(Extent extent);
std::vector<ExtremeCase> lock_up(Extent extent);
std::vector<ExtremeCase> branches(Extent extent);
std::vector<ExtremeCase> redundant(Extent extent);
std::vector<ExtremeCase> scales(Extent extent);
std::vector<ExtremeCase> long_runs(Extent extent);
std::vector<ExtremeCase> bad_starts(Extent extent);
std::vector<ExtremeCase> bad_input(Extent extent);
std::vector<ExtremeCase> reused_pivots(Extent extent);
std::vector<ExtremeCase> idle_freedom(Extent extent);
std::vector<ExtremeCase> tolerances(Extent extent);

/// Chains moved by as many motions, in one mechanism.
ExtremeCase case_of(std::string name, std::vector<DyadChain> chains, std::vector<Motion> motions,
                    const TimeGrid& grid);
/// One, whose crank turns at a constant rate (rad/s).
ExtremeCase case_of(std::string name, const DyadChain& chain, double rate, const TimeGrid& grid);

/// The dyads of the suite's four-bar: crank 2, links and distances 6, all closed exactly at the
/// start. Lengths times `scale`.
DyadChain usual_chain(int dyads, double start, double scale = 1);

}  // namespace desmo::extreme
