#pragma once

#include <optional>
#include <span>
#include <vector>

#include "formulations/verification/branch/singularity_crossing.h"

namespace desmo {

class StraightPath;

/// A change point that a motion passes, turns back at or rests on.
struct PassedPoint {
  double time;           ///< of the point [s], about
  double after, before;  ///< times of the proven instants next to it [s], after ≤ time < before;
                         ///< before is infinite if the motion stays on it or next to it
  /// The first proven instant beyond, with all rates. Empty where `before` is infinite.
  InstantCopy first{};

  DriverLine line;  ///< of the drivers that the point depends on
  double width;     ///< arc on either side of line.origin that the polynomials span
  std::vector<Quintic<double>> polynomials;  ///< of each coordinate across the point, of s / width

  /// Returns `first`, from which BranchPath goes on.
  CertifiedInstant beyond() const { return first.view(); }
  /// Finds positions of all coordinates at a time [s] between `after` and `before`, where no
  /// instant is proven and rates have no digits. Shifts line and polynomials to the values that the
  /// other drivers have then. Returns nothing if no proven path leads the positions there.
  /// - path: of the model that passes the point
  std::vector<double> find_positions(StraightPath& path, double time);

 private:
  bool move_line_to(std::span<const double> drivers, StraightPath& path, TestBudget& budget);
};

/// Passes the change point on which a motion is stuck (PathEnd::stuck), if there is a smooth
/// continuation (SingularityCrossing). Then the motion goes on beyond the point or, where its
/// drivers turn back, on the branch that it came from. Returns nothing at a fold, where branches
/// are too alike to be told apart, where the path of the drivers has a corner, and where tests run
/// out.
/// - last: the last proven instant, where BranchPath::present() is
/// - group: the singular group (FollowedStep::group); no_position: it is not known
/// - budget: several passages may share it. Each way in which one is tried takes half of it at most
///
/// If the path was stuck for want of tests, the instant beyond() may still be before the change
/// point. The motion is then stuck again.
///
///   const FollowedStep step = path.go_to(time);
///   if (step.end == PathEnd::stuck)
///     if (auto point = pass_change_point(model, path.present(), step.group, budget))
///       path.start_at(point->beyond());   // find_positions() between `after` and `before`
std::optional<PassedPoint> pass_change_point(const Model& model, const CertifiedInstant& last,
                                             GroupId group, TestBudget& budget);

/// Passes the change point on which a motion begins. The path that led there is another one: that
/// from the drawing.
/// - last: the last proven instant on that path; its time is not read
/// - direction: rates of the drivers on that path, of any length
/// - start: time at which the motion begins [s], which becomes PassedPoint::after although no
///   instant is proven there
std::optional<PassedPoint> pass_change_point(const Model& model, const CertifiedInstant& last,
                                             std::span<const double> direction, double start,
                                             GroupId group, TestBudget& budget);

}  // namespace desmo
