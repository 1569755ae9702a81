#pragma once

#include <array>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "cases/extremes/extremes.h"
#include "cases/mechanism/builder.h"

/// The rows of the table of extremes (extremes.h), one .cpp each: a function that makes the cases.
namespace desmo::extremes {

using Cases = std::vector<ExtremeCase>(Extent extent);
Cases long_chains, near_dead_points, singular_positions, lock_up, branches, redundant, scales,
    long_runs, bad_starts, bad_input, reused_pivots, idle_freedom, tolerances, estimates,
    change_points;

/// Makes a case of several dyad chains in one mechanism, each driven by its own motion.
ExtremeCase case_of(std::string name, std::vector<DyadChain> chains, std::vector<Motion> motions,
                    const TimeGrid& grid);
/// Makes a case of one dyad chain, whose crank turns at a constant rate [rad/s].
ExtremeCase case_of(std::string name, const DyadChain& chain, double rate, const TimeGrid& grid);

/// Returns the case with ExtremeCase::may_fail set.
ExtremeCase may_fail(ExtremeCase c);

/// Adds a dyad after the last one, or after the crank; closed_dyad() places its joint. pivot: x of
/// the rocker's pivot, which is on the x axis.
void add_dyad(DyadChain& chain, double pivot, double coupler, double rocker, int side = 1);

/// Makes a chain of one dyad; start: initial angle of the crank [rad]. See add_dyad().
DyadChain one_dyad(double crank, double start, double pivot, double coupler, double rocker,
                   int side = 1);

/// Adds a closed loop of bodies to a spatial mechanism. The last body is the ground. Each body is
/// hinged to the next one at a corner, about an axis. The direction from the first corner to the
/// second is driven: its angle is 0 at the vector `from`, and π/2 at `towards`.
/// - body: name of the bodies, to which their numbers are added
/// - corners, axes: indices of points and vectors, two or more, as many of either
/// - from, towards: indices of vectors, which the ground is made to carry
void hinge_loop(MechanismBuilder& builder, const std::string& body, std::span<const int> corners,
                std::span<const int> axes, int from, int towards);

/// A link of a loop in parameters of Denavit and Hartenberg: angle at its hinge [rad], distance to
/// the next hinge, and angle between the axes of the two hinges [rad].
struct HingedLink {
  double angle, length, twist;
};

/// Adds a loop of links by hinge_loop(). It is drawn from the origin on: its first axis is z, its
/// first angle counts from x. Returns the end of the last link, which is the origin up to rounding
/// if the links close.
Mechanism::Vec add_linkage(MechanismBuilder& builder, std::span<const HingedLink> links);

/// Returns Bennett's linkage: opposite links are equal, and a / sin α = b / sin β.
/// - start: angle of the first hinge [rad]
/// - length, twist: length a and twist α [rad] of the first link
/// - other_twist: twist β of the second link [rad]; its length b follows
std::array<HingedLink, 4> bennett_links(double start, double length, double twist,
                                        double other_twist);

/// Initial angle of the crank of dyad chains, unless a case says otherwise [rad].
inline constexpr double chain_start = std::numbers::pi / 3;

/// Makes the dyads of the suite's four-bar, closed at the start up to rounding: a crank of 2; links
/// of 6; pivots 6 apart. scale: factor of all lengths.
DyadChain usual_chain(int dyads, double start, double scale = 1);

}  // namespace desmo::extremes
