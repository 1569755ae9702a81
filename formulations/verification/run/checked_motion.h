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

/// The motion of a checked run, without the formulation that solves it: corrects instants, follows
/// the steps between them, and says what is proven of each.
class CheckedMotion {
 public:
  /// levels: up to which each coordinate is solved (Plan::levels). Model and levels must outlive
  /// this.
  CheckedMotion(const Model& model, std::span<const Level> levels);

  /// Goes from the drawing to a time, where the motion begins. The next instant is the one there.
  void begin(double time);
  /// Goes on from a proven instant instead, wherever the motion was before. Returns whether it can.
  bool continue_from(const CertifiedInstant& instant);

  /// Checks the next instant, which a formulation has solved. The result is valid until the next
  /// call.
  const CheckedInstant& check(const Instant& solved) { return *take(solved, true); }
  /// Solves the next instant, which no formulation has found; null where the motion does not lead
  /// there. wanted: its index, time and, by the sizes of their spans, its levels.
  const CheckedInstant* solve(const Instant& wanted) { return take(wanted, false); }

  /// Returns whether an instant is in the last step's tube; false after sub-steps. tolerances: how
  /// far a coordinate that meets the tolerance of the equations may be from the exact one.
  bool is_on_step(const Instant& instant, std::span<const double> tolerances) const;
  /// Returns to where the last check() began.
  void return_to_last();

  /// Returns the last proven instant, where the path is.
  const CertifiedInstant& present() const { return follower_->path.present(); }

  /// Returns the positions up to which the motion was followed from the drawing.
  std::vector<double> followed_to() const {
    if (!follows()) return start() == FoundStart::Stage::reached ? std::vector<double>() : start_.q;
    const std::span<const double> q = present().values.position;
    return {q.begin(), q.end()};
  }

  /// Returns where the way from the drawing is blocked, if it is.
  FoundStart::Stage start() const {
    return start_.point ? FoundStart::Stage::reached : start_.stage;
  }

 private:
  /// Returns whether the path begins at the last proven instant.
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
    bool on_path = false;               // the branch is known
    std::optional<RowFlag> lost;        // since then the branch is unknown
    std::optional<RowFlag> first_flag;  // of the first row, whose way from the drawing crosses
    std::optional<PassedPoint> point;   // beyond it the path has not begun
  };

  const Model& m_;
  const std::span<const Level> levels_;
  std::unique_ptr<Follower> follower_;
  State state_, last_;        // last_: in which the last check began
  InstantCopy last_instant_;  // where the path was then
  FoundStart start_;
  FollowedStep step_;  // the last one
  std::vector<double> on_point_, no_rates_;
  CheckedInstant result_;
};

}  // namespace desmo
