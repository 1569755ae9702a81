// Rows that a checked motion delivers, and their flags.
#include <cmath>

#include "formulations/verification/run/checked_motion.h"

namespace desmo {

void CheckedMotion::deliver(const RefinedInstant& r) {
  result_.instant = r.instant;
  result_.radius = r.radius;
  result_.condition = r.last.condition;
  if (r.proven) {
    follower_->flag_misfit(r, result_.flag);
    return;
  }
  result_.flag = {.kind = RowFlag::Kind::unproven,
                  .after = step_.time,
                  .before = r.instant.time,
                  .group = r.last.group,
                  .failure = r.last.failure};
}

/// Delivers the end of the path, up to the levels of `at`.
void CheckedMotion::deliver_path(const Instant& at) {
  result_.is_elsewhere = true;
  deliver(follower_->refinement.refine(with_values(at, follower_->path.present().values)));
}

/// Delivers the position on the change point, which has no rates. Returns whether it is known.
bool CheckedMotion::deliver_point(const Instant& at) {
  PassedPoint& point = *state_.point;
  std::unique_ptr<StraightPath>& path = follower_->straight;
  if (!path) path = std::make_unique<StraightPath>(follower_->model);
  on_point_ = point.find_positions(*path, at.time);
  if (on_point_.empty()) {
    step_.group = no_position;  // the group that is stuck now is not known
    return false;
  }
  result_.is_elsewhere = result_.is_on_point = true;
  result_.instant = with_values(at, {on_point_, no_rates_, no_rates_});
  result_.condition = INFINITY;
  result_.flag = {.kind = RowFlag::Kind::on_point,
                  .after = point.after,
                  .before = point.before,
                  .group = step_.group};
  return true;
}

/// Flags the result where its branch is unknown, or the way to it from the drawing crosses a change
/// point. A worse flag stays, a misfit in any.
void CheckedMotion::complete_flag() {
  for (const std::optional<RowFlag>& flag : {state_.lost, state_.first_flag})
    if (flag) worsen(result_.flag, *flag);
  state_.first_flag.reset();
  if (result_.flag) result_.flag->time = result_.instant.time;
}

}  // namespace desmo
