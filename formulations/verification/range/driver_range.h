#pragma once

#include <optional>
#include <span>
#include <vector>

#include "formulations/model/model.h"
#include "formulations/verification/range/range_limits.h"

namespace desmo {

/// The reason why a driver goes no further.
enum class RangeStop {
  dead_point,    ///< the mechanism locks: the driver turns back along the curve of positions
  full_turn,     ///< the mechanism is back at its start
  zero_length,   ///< the driven distance has become zero
  other_branch,  ///< an equation that was left out as dependent holds no longer
  start,         ///< the start is singular: curves of positions cross there
  not_reached,   ///< no position is found any further, for a reason unknown
  none,          ///< nothing: two turns, or ten times the mechanism's size
};

/// The end of a driver's range in one direction. Values of the driver are in rad or the unit of
/// length.
struct RangeEnd {
  RangeStop stop = RangeStop::none;
  double value = 0;  ///< last value of the driver with a solved position
  /// Value next to it without a position on this branch; equal to it where nothing locks.
  double beyond = 0;
  int turns = 0;                   ///< full_turn: turns until the mechanism is back, 1 or 2
  std::vector<GroupId> groups{};   ///< dead_point: groups that lock, several where all do at once
  std::vector<EntityId> moving{};  ///< dead_point: what can still move while all drivers rest
  std::vector<int> constraints{};  ///< dead_point: those that hold the driver, by force
};

/// A singular position that the mechanism passes: branches cross or touch there.
struct ChangePoint {
  double value;            ///< of the driver
  GroupId group;           ///< group whose determinant is zero; no_position: not known
  bool is_double = false;  ///< a determinant is zero without a change of its sign: branches touch,
                           ///< or the driver rests for an instant
};

/// Range of a driver from a position, while the others rest.
struct DriverRange {
  double start;          ///< value of the driver at the given position
  bool is_idle = false;  ///< the driver moves nothing but itself
  RangeEnd down, up;
  /// The end on the second branch that begins at a dead point; nothing unless the start is one.
  /// Both branches lead in the direction that is not locked.
  std::optional<RangeEnd> other_branch;
  std::vector<ChangePoint> change_points;  ///< ascending
};

/// Finds the range of a driver along the branch of a position. It follows the curve of positions
/// by its arc length in steps that are refused where the curve bends or signs of determinants
/// change, so as to stay on the branch. A dead point is bracketed by two solved positions of the
/// curve, between which the driver turns back: `value` and `beyond` differ by less than 1e-9 rad or
/// characteristic lengths. Change points are found to the same accuracy where they are simple, and
/// where a determinant has a double root; roots of a higher order without a change of sign are not
/// noticed. Several loops that lock at once are named together. Groups with more equations than
/// they need are followed by those that are independent there (with_chosen_equations()).
/// - q: the position, solved or, at a dead point, nearly so (coordinates)
/// - driver: position in Model::drivers
///
///   const RangeEnd up = find_range(model, formulation->q(), 0).up;
///   if (up.stop == RangeStop::dead_point) std::printf("locks at %g rad\n", up.value);
///
/// Throws std::invalid_argument for a q of another size and a driver that the model does not have.
/// Throws std::runtime_error where there is no position near q.
///
/// It belongs to verification, since it needs determinants of irreducible blocks and the check of
/// branches. Not for timed code: it allocates.
DriverRange find_range(const Model& model, std::span<const double> q, int driver,
                       const RangeLimits& limits = {});

}  // namespace desmo
