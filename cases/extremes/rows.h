#pragma once

#include <array>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "cases/extremes/extremes.h"
#include "cases/mechanism/builder.h"

/// The rows of the table of extremes (extremes.h), one .cpp each: each makes the cases of its row.
namespace desmo::extremes {

using Cases = std::vector<ExtremeCase>(Extent extent);
Cases long_chains, near_dead_points, singular_positions, lock_up, branches, redundant, scales,
    long_runs, bad_starts, bad_input, reused_pivots, idle_freedom, tolerances, estimates,
    change_points;

/// Makes a case of several chains in one mechanism, each driven by its own motion.
ExtremeCase case_of(std::string name, std::vector<DyadChain> chains, std::vector<Motion> motions,
                    const TimeGrid& grid);
/// Makes a case of one chain, whose crank turns at a constant rate [rad/s].
ExtremeCase case_of(std::string name, const DyadChain& chain, double rate, const TimeGrid& grid);

/// Returns the case with a flag as good as an answer.
ExtremeCase may_fail(ExtremeCase c);

/// Adds a dyad that follows the last one, or the crank, and is closed there (closed_dyad).
void add_dyad(DyadChain& chain, double pivot, double coupler, double rocker, int side = 1);

/// Makes a chain of one dyad. pivot: of the rocker, on the x axis.
DyadChain one_dyad(double crank, double start, double pivot, double coupler, double rocker,
                   int side = 1);

/// Adds a closed chain of bodies, the last of which is the ground, to a spatial mechanism: each is
/// hinged to the next at a corner, about an axis. The angle of the first line, from one vector of
/// the ground towards another, is driven.
/// - body: the name of the bodies before their numbers
/// - corners, axes: points and vectors, two or more
void hinge_loop(MechanismBuilder& mechanism, const std::string& body, std::span<const int> corners,
                std::span<const int> axes, int from, int towards);

/// A link of a closed chain, by Denavit and Hartenberg: the angle of its hinge, the distance and
/// the angle from there to the next hinge.
struct HingedLink {
  double angle, length, twist;
};

/// Adds a closed chain of links (hinge_loop), drawn from the origin on: its first axis is z, its
/// first angle counts from x. Returns where the last link ends, the origin but for rounding.
Mechanism::Vec add_linkage(MechanismBuilder& mechanism, std::span<const HingedLink> links);

/// Returns Bennett's linkage, whose opposite links are equal: a / sin α = b / sin β.
/// - start: angle of the first hinge [rad]
/// - length, twist: a [m] and α [rad] of the first link; other_twist: β of the second [rad]
std::array<HingedLink, 4> bennett_links(double start, double length, double twist,
                                        double other_twist);

/// Initial angle of the crank of dyad chains, unless a case says otherwise [rad].
inline constexpr double chain_start = std::numbers::pi / 3;

/// Makes the dyads of the suite's four-bar: crank 2, links and distances 6, all closed exactly at
/// the start. scale: factor on all lengths.
DyadChain usual_chain(int dyads, double start, double scale = 1);

}  // namespace desmo::extremes
