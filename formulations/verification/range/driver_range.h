#pragma once

#include <optional>
#include <span>
#include <vector>

#include "formulations/model/model.h"
#include "formulations/verification/range/range_limits.h"

namespace desmo {

/// Reason why a driver goes no further.
enum class RangeStop {
  dead_point,    ///< the mechanism locks: the driver turns back along the curve of positions
  full_turn,     ///< the mechanism is back at its start
  zero_length,   ///< the driven distance has become zero
  other_branch,  ///< a left-out equation no longer holds
  start,         ///< the start is singular: curves of positions cross there
  not_reached,   ///< no further position is found, for an unknown reason or by max_steps
  none,          ///< nothing stops it within two turns, or ten times the mechanism's size
};

/// The end of a driver's range in one direction. Values of the driver are in rad or the unit of
/// length.
struct RangeEnd {
  RangeStop stop = RangeStop::none;
  double value = 0;  ///< last value of the driver with a solved position
  /// Value after it without a position on this branch; equal to `value` if nothing locks.
  double beyond = 0;
  int turns = 0;                   ///< full_turn: turns until the mechanism is back, 1 or 2
  std::vector<GroupId> groups{};   ///< dead_point: groups that lock, several if they lock at once
  std::vector<EntityId> moving{};  ///< dead_point: what can still move while all drivers rest
  std::vector<int> constraints{};  ///< dead_point: what holds the driver, largest force first
};

/// A singular position that the mechanism passes: branches cross or touch there.
struct ChangePoint {
  double value;            ///< of the driver
  GroupId group;           ///< group whose determinant is zero; no_position: not known
  bool is_double = false;  ///< the determinant does not change its sign: branches touch, or the
                           ///< driver rests for an instant
};

/// Range of a driver from a position, while the others rest.
struct DriverRange {
  double start;          ///< value of the driver at the given position
  bool is_idle = false;  ///< the driver moves nothing but itself: both ends are at the start
  RangeEnd down, up;
  /// End on the second branch, if the start is a dead point. Both branches begin there and lead in
  /// the direction that is not locked.
  std::optional<RangeEnd> other_branch;
  std::vector<ChangePoint> change_points;  ///< ascending
};

/// Finds the range of a driver along the branch of a position. Follows the curve of positions by
/// its arc. To stay on the branch, steps are shortened where the curve bends or signs of
/// determinants change. Two solved positions of the curve bracket a dead point, between which the
/// driver turns back: `value` and `beyond` differ by less than 1e-9 rad or characteristic lengths,
/// and by the spacing of doubles far from zero.
/// Change points are found to the same accuracy: simple and double roots of a determinant. Roots of
/// a higher order without a change of sign are not noticed. Loops that lock at once are named
/// together. Groups with more equations than unknowns are followed by equations that are
/// independent there (with_chosen_equations()).
/// - q: the position, solved or, at a dead point, nearly so (coordinates)
/// - driver: position in Model::drivers
///
///   const RangeEnd up = find_range(model, formulation->q(), 0).up;
///   if (up.stop == RangeStop::dead_point) std::printf("locks at %g rad\n", up.value);
///
/// Throws std::invalid_argument for a q of another size and a driver that the model does not have.
/// Throws std::runtime_error if there is no position near q. Allocates: keep it out of timed code.
DriverRange find_range(const Model& model, std::span<const double> q, int driver,
                       const RangeLimits& limits = {});

}  // namespace desmo
