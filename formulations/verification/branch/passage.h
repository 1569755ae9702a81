#pragma once

#include <optional>
#include <span>
#include <vector>

#include "formulations/verification/branch/straight_crossing.h"

namespace desmo {

class StraightPath;

/// A change point that a motion passes, turns back at or rests on.
struct PassedPoint {
  double time;           ///< of the point [s], about
  double after, before;  ///< of the proven instants next to it [s]; before: infinite where the
                         ///< motion rests on the point for good
  /// The first proven instant beyond, up to its accelerations. Empty where `before` is infinite.
  InstantCopy first{};

  DriverLine line;  ///< of the drivers that the point depends on
  double width;
  std::vector<Quintic<double>> polynomials;  ///< of each coordinate across the point, of s / width

  /// Returns `first`, from which BranchPath goes on.
  CertifiedInstant beyond() const { return first.view(); }
  /// Finds positions of all coordinates at a time between `after` and `before`, where no instant is
  /// proven and rates have no digits. Line and polynomials move on with the other drivers. Empty
  /// where paths lead neither what depends on these nor, beyond the polynomials, the rest.
  /// path: of the model that passes the point
  std::vector<double> find_positions(StraightPath& path, double time);

 private:
  bool move_line_to(std::span<const double> drivers, StraightPath& path);
};

/// Passes the change point on which a motion is stuck (PathEnd::stuck), if there is a smooth
/// continuation (StraightCrossing): then the motion goes on beyond the point or, where its drivers
/// turn back, on the branch that it came from. Nothing where there is none: at a fold, where
/// several branches are alike up to their fourth derivatives, and where the path of several
/// drivers, on which the point depends, has a corner.
/// - last: the last proven instant, where BranchPath::present() is
/// - group: that is singular on the point (FollowedStep::group); no_position: it is not known
///
/// A path that is stuck for want of tests may be before the point still when it has passed, and
/// then be stuck again.
///
///   const FollowedStep step = path.go_to(time);
///   if (step.end == PathEnd::stuck)
///     if (auto point = pass_change_point(model, path.present(), step.group))
///       path.start_at(point->beyond());   // rows between after and before:
///       point->find_positions()
std::optional<PassedPoint> pass_change_point(const Model& model, const CertifiedInstant& last,
                                             GroupId group = no_position);

/// Passes the change point on which a motion begins, when something else leads there: the way from
/// the drawing.
/// - last: the last proven instant on that way; its time is not read
/// - direction: of the drivers on the way, of any length
/// - start: of the motion [s]: PassedPoint::after. No instant is proven there
std::optional<PassedPoint> pass_change_point(const Model& model, const CertifiedInstant& last,
                                             std::span<const double> direction, double start,
                                             GroupId group = no_position);

}  // namespace desmo
