#include "formulations/verification/run/checked_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "formulations/modelling/independence/linearisation.h"
#include "formulations/verification/branch/chosen_equations.h"

namespace desmo {

CheckedMotion::CheckedMotion(const Model& m, std::span<const Level> levels)
    : m_(m),
      levels_(levels),
      follower_(std::make_unique<Follower>(nullptr, m, levels)),
      no_rates_(m.coordinates(), NAN) {}

void CheckedMotion::begin(double time) {
  state_ = {};
  start_ = find_start(m_, time);
  if (follower_->chosen) follower_ = std::make_unique<Follower>(nullptr, m_, levels_);
  step_ = {.time = time, .group = start_.group};
  if (!start_.passed.empty() || start_.point)
    state_.first_flag = start_flag(RowFlag::Kind::crossing, start_, time);
  if (start_.point) {
    state_.point = *start_.point;
    state_.on_path = true;
  } else if (start_.stage == FoundStart::Stage::reached) {
    const auto begins = [&] {
      const RefinedInstant& r = follower_->refinement.refine(instant_of(time, {start_.q}));
      return r.proven && follower_->path.start_at(certified(r));
    };
    state_.on_path = begins() || (choose_other_equations(start_.q) && begins());
  }
  if (!state_.on_path) state_.lost = start_flag(RowFlag::Kind::branch, start_, time);
}

bool CheckedMotion::continue_from(const CertifiedInstant& instant) {
  state_ = {};
  follower_->left_out.take_between();
  start_ = {};
  step_ = {.time = instant.time};
  const auto begins = [&] { return follower_->path.start_at(instant); };
  state_.on_path = begins() || (choose_other_equations(instant.values.position) && begins());
  return state_.on_path;
}

void CheckedMotion::return_to_last() {
  state_ = last_;
  if (follows()) state_.on_path = follower_->path.start_at(last_instant_.view());
}

bool CheckedMotion::is_on_step(const Instant& instant, std::span<const double> tolerances) const {
  return step_.end == PathEnd::same && step_.sub_steps == 1 &&
         follower_->path.contains(instant.time, instant.q, tolerances, result_.condition);
}

/// Makes the result of an instant, which a formulation has solved or not. Returns null if it has
/// not, and the motion does not lead there either.
const CheckedInstant* CheckedMotion::take(const Instant& at, bool is_solved) {
  last_ = state_;
  if (follows()) last_instant_.assign(follower_->path.present());
  // First tries other equations, then passages: a position that is regular by other equations is no
  // change point.
  for (bool may_pass = !has_other_equations(m_);; may_pass = true) {
    result_ = {};
    result_.is_elsewhere = !is_solved;
    const RefinedInstant* const refined = is_solved ? &follower_->refinement.refine(at) : nullptr;
    const RefinedInstant* const found = refined && refined->proven ? refined : nullptr;
    if (reach(at, found, may_pass) && (may_pass || !is_led_astray())) break;
    if (!may_pass && (is_solved || follows())) {
      if (is_led_astray()) {  // forgets what the present check has found
        return_to_last();
        follower_->left_out.take_between();
      }
      choose_other_equations(follows() ? follower_->path.present().values.position : at.q);
      continue;
    }
    if (!is_solved) return nullptr;
    if (found) {
      // The instant is proven, but no proven path leads to it: its branch is unknown. The path
      // begins anew from it.
      if (!state_.lost)
        state_.lost = {.kind = RowFlag::Kind::branch,
                       .after = step_.time,
                       .before = at.time,
                       .group = step_.group,
                       .out_of_tests = step_.out_of_tests};
      state_.point.reset();
      // If tests ran out, they would do so in each step: then the path does not begin again.
      state_.on_path =
          !state_.lost->out_of_tests && follower_->path.start_at(certified(*found, levels_));
    }
    deliver(*refined);
    break;
  }
  if (!state_.point) follower_->straight.reset();  // only rows on a change point need its memory
  complete_flag();
  return &result_;
}

/// Follows the motion to an instant's time. The result is `found` if the motion leads to it, else
/// the end of the path or, on a change point, the position there. Returns false if there is none.
/// - found: the refined instant of the formulation; null: it has none that is proven
/// - may_pass: change points are passed
bool CheckedMotion::reach(const Instant& at, const RefinedInstant* found, bool may_pass) {
  if (!state_.on_path) return false;
  std::optional<PassedPoint>& point = state_.point;
  BranchPath& path = follower_->path;
  // All parts of the step share one budget, and so do all passages. Each part counts as at least
  // one test, so the loop ends.
  TestBudget passages(BranchPath::max_tests);
  for (int tests = 0; tests < BranchPath::max_tests; tests += std::max(1, step_.tests)) {
    if (point) {
      if (at.time < point->before) return deliver_point(at);
      if (!path.start_at(point->beyond())) return false;
      point.reset();
    }
    step_ = found ? path.follow(certified(*found, levels_)) : path.go_to(at.time);
    if (step_.end != PathEnd::stuck) {
      if (found && step_.end == PathEnd::same)
        deliver(*found);
      else
        deliver_path(at);
      return true;
    }
    if (may_pass && !step_.out_of_tests)
      point = pass_change_point(follower_->model, path.present(), step_.group, passages);
    if (!point) return false;
    result_.flag = {.kind = RowFlag::Kind::crossing,
                    .after = point->after,
                    .before = point->before,
                    .group = step_.group};
  }
  point.reset();
  step_.out_of_tests = true;
  return false;
}

/// Returns whether a left-out equation is off by more than max_misfit at the present instant or on
/// the way to it. Where a linkage closes only to its digits, two branches of the kept equations may
/// pass each other closely. A path then turns into the other branch, while the mechanism goes on.
bool CheckedMotion::is_led_astray() const {
  const LeftOutEquations& left_out = follower_->left_out;
  std::optional<Misfit> misfit = result_.flag ? result_.flag->misfit : std::nullopt;
  if (!misfit && left_out.between()) misfit = left_out.between()->misfit;
  return last_.on_path && !last_.point && misfit && misfit->relative > max_misfit;
}

/// Takes other equations of overconstrained groups if the kept ones are nearly dependent at
/// positions q. Returns false if no others are better or they do not agree on the last instant.
bool CheckedMotion::choose_other_equations(std::span<const double> q) {
  auto chosen = with_chosen_equations(follower_->model, q);
  if (!chosen) return false;
  auto other = std::make_unique<Follower>(std::move(chosen), m_, levels_);
  if (follows()) {  // the last instant must be a solution by the other equations, too
    const CertifiedInstant& present = follower_->path.present();
    const RefinedInstant& r = other->refinement.refine(instant_of(present.time, present.values));
    if (!r.proven || !other->path.start_at(certified(r, levels_))) return false;
  }
  other->left_out.note(follower_->left_out.take_between());
  follower_ = std::move(other);
  return true;
}

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
/// point. A worse flag stays. So does a misfit, in any flag.
void CheckedMotion::complete_flag() {
  for (const std::optional<RowFlag>& flag : {state_.lost, state_.first_flag})
    if (flag) worsen(result_.flag, *flag);
  state_.first_flag.reset();
  if (result_.flag) result_.flag->time = result_.instant.time;
}

}  // namespace desmo
