#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "formulations/verification/branch/passage.h"
#include "formulations/verification/branch/start.h"
#include "formulations/verification/run/checked_run.h"
#include "formulations/verification/run/follower.h"

namespace desmo {

/// The motion of a checked run, without the formulation that solves it. It corrects instants,
/// follows the steps between them, and says what is proven of each.
class CheckedMotion {
 public:
  /// levels: level up to which each coordinate is solved (Plan::levels); empty: up to the levels of
  /// each instant. Model and levels must outlive this object.
  CheckedMotion(const Model& model, std::span<const Level> levels);

  /// Begins the motion at a time [s]. Follows it there from the drawing, if the way is not blocked.
  /// The next instant that is checked must be the one at that time.
  void begin(double time);
  /// Begins at a proven instant instead, wherever the motion was before. Returns whether it can.
  bool continue_from(const CertifiedInstant& instant);

  /// Checks the next instant, which a formulation has solved. The result is valid until the next
  /// call.
  const CheckedInstant& check(const Instant& solved) { return *take(solved, true); }
  /// Solves the next instant where no formulation has. Returns null if no proven path leads there:
  /// the motion locks, tests ran out, or it is not followed.
  /// - wanted: its index and time; the sizes of its spans tell the levels
  const CheckedInstant* solve(const Instant& wanted) { return take(wanted, false); }

  /// Returns whether an instant between those of the last step lies in its tube, widened by
  /// condition × tolerance. Returns false after sub-steps.
  /// - tolerances: nominal magnitude × tolerance of the equations, of each coordinate
  bool is_on_step(const Instant& instant, std::span<const double> tolerances) const;
  /// Returns to the state before the last check() or solve().
  void return_to_last();

  /// Returns the instant that the path reached last. Rows whose branch is unknown may be later.
  const CertifiedInstant& present() const { return follower_->path.present(); }

  /// Returns the last positions to which the motion is proven to lead from the drawing, or from
  /// where it began again. Empty: they are not known.
  std::vector<double> followed_to() const {
    if (!follows()) return start() == FoundStart::Stage::reached ? std::vector<double>() : start_.q;
    const std::span<const double> q = present().values.position;
    return {q.begin(), q.end()};
  }

  /// Returns the stage at which the way from the drawing is blocked. A change point on which the
  /// motion begins counts as reached.
  FoundStart::Stage start() const {
    return start_.point ? FoundStart::Stage::reached : start_.stage;
  }

 private:
  /// Returns whether the next step begins at follower_->path.present(). On a change point it begins
  /// at state_.point->beyond() instead. Without state_.on_path the motion is not followed.
  bool follows() const { return state_.on_path && !state_.point; }
  const CheckedInstant* take(const Instant& at, bool is_solved);
  bool reach(const Instant& at, const RefinedInstant* found, bool may_pass);
  bool choose_other_equations(std::span<const double> q);
  bool is_led_astray() const;
  void deliver(const RefinedInstant& refined);
  void deliver_path(const Instant& at);
  bool deliver_point(const Instant& at);
  void complete_flag();

  /// State in which the next check begins, but for the path's instant.
  struct State {
    bool on_path = false;         // the motion is followed, from the drawing or, since `lost`, anew
    std::optional<RowFlag> lost;  // flag of all rows since the branch became unknown
    std::optional<RowFlag> first_flag;  // flag of the first row: the way to it crosses a point
    std::optional<PassedPoint> point;   // change point that the motion has not left yet
  };

  const Model& m_;
  const std::span<const Level> levels_;
  std::unique_ptr<Follower> follower_;
  State state_, last_;        // last_: before the last check
  InstantCopy last_instant_;  // instant of the path before the last check
  FoundStart start_;
  FollowedStep step_;  // last step of the path
  std::vector<double> on_point_, no_rates_;
  CheckedInstant result_;
};

}  // namespace desmo
