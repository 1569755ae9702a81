#include "bench/cli/view/motion_recorder.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bench/cli/solve/check_notes.h"
#include "bench/cli/solve/failure_notes.h"

namespace desmo::cli {

MotionRecorder::MotionRecorder(const Model& model, Measures& measures, const DisplayUnits& units,
                               const TimeGrid& grid, std::size_t max_kept,
                               bench::Progress* progress)
    : model_(model),
      measures_(measures),
      units_(units),
      grid_(grid),
      max_kept_(std::max<std::size_t>(max_kept, 4)),
      progress_(progress) {}

CheckedSummary MotionRecorder::run(Formulation& formulation) {
  CheckOptions options;
  options.past_failures = true;
  options.checked = [this](const CheckedInstant& instant) { record(instant); };
  const CheckedSummary summary =
      run_checked(formulation, grid_, {Level::acceleration}, *this, options);
  if (passed_) instants_.push_back(*std::exchange(passed_, {}));
  is_over_ = true;
  condition_ = 0;
  radius_ = no_radius;
  if (instants_.empty()) {
    const std::vector<double> at_rest(model_.estimate.size());
    instants_.push_back(
        {0, state_of({0, grid_.start, model_.estimate, at_rest, at_rest}), NAN, no_radius});
  }
  flag_failures(summary);
  std::ranges::stable_sort(flags_, {}, &Flag::from);
  return summary;
}

Flow MotionRecorder::observe(const Instant&) noexcept {
  if (progress_) progress_->add_done();
  return overflowed_ ? Flow::stop : Flow::go_on;
}

void MotionRecorder::record(const CheckedInstant& checked) {
  const Instant& instant = checked.instant;
  checked.for_each_flag([&](const RowFlag& f) { flag(f, instant.index); });
  if (checked.is_on_point) return;  // an instant on a change point has no rates
  const auto n = static_cast<std::size_t>(model_.coordinates());
  for (const std::span<const double> values : {instant.q, instant.qd, instant.qdd})
    overflowed_ = overflowed_ ||
                  !std::ranges::all_of(values.first(n), [](double x) { return std::isfinite(x); });
  if (overflowed_) return;
  ++solved_;
  condition_ = std::max(condition_, checked.condition);
  for (const Level level : all_levels)
    if (std::isfinite(checked.relative_radius[level]))  // else some coordinate has no proof
      radius_[level] = std::fmax(radius_[level], checked.relative_radius[level]);
  keep({instant.index, state_of(instant), condition_, radius_});
}

std::vector<double> MotionRecorder::state_of(const Instant& instant) {
  const auto n = static_cast<std::size_t>(model_.coordinates()) + measures_.list().size();
  const Instant all = measures_.extend(instant);
  std::vector<double> state;
  state.reserve(3 * n);
  for (const std::span<const double> values : {all.q, all.qd, all.qdd})
    state.insert(state.end(), values.begin(), values.begin() + static_cast<std::ptrdiff_t>(n));
  return state;
}

/// Keeps an instant whose index is a multiple of the stride. Holds any other one until the next
/// instant comes: if that comes after a gap, the one held is kept, too.
void MotionRecorder::keep(RecordedInstant instant) {
  if (passed_ && passed_->index + 1 < instant.index)  // the last one before a gap
    instants_.push_back(*std::move(passed_));
  passed_.reset();
  if (instant.index % stride_ != 0) {
    passed_ = std::move(instant);
    return;
  }
  instants_.push_back(std::move(instant));
  condition_ = 0;
  radius_ = no_radius;
  if (instants_.size() > max_kept_) thin_out();
}

void MotionRecorder::thin_out() {
  stride_ *= 2;
  std::vector<RecordedInstant> kept;
  for (std::size_t i = 0; i < instants_.size(); ++i) {
    RecordedInstant& instant = instants_[i];
    const bool before_gap =
        i + 1 == instants_.size() ? is_over_ : instants_[i + 1].index > instant.index + stride_;
    condition_ = std::max(condition_, instant.condition);
    for (const Level level : all_levels)
      radius_[level] = std::fmax(radius_[level], instant.radius[level]);
    if (instant.index % stride_ != 0 && !before_gap) continue;
    instant.condition = std::exchange(condition_, 0);
    instant.radius = std::exchange(radius_, no_radius);
    kept.push_back(std::move(instant));
  }
  instants_ = std::move(kept);
}

/// Flags the interval of a row, or lengthens that of the row before where it has the same flag.
void MotionRecorder::flag(const RowFlag& f, int index) {
  const bool passes = f.is_of_change_point();
  const Flag::Kind kind = passes                            ? Flag::Kind::crossing
                          : f.kind == RowFlag::Kind::branch ? Flag::Kind::branch
                          : f.kind == RowFlag::Kind::misfit ? Flag::Kind::misfit
                                                            : Flag::Kind::unproven;
  const double from = passes ? std::max(f.after, grid_.start) : f.time,
               to = passes ? std::min(f.before, grid_.time(grid_.instants - 1)) : f.time;
  for (auto& [last_row, place, group] : lasting_) {
    Flag& last = flags_[place];
    if (last_row + 1 != index || last.kind != kind || group != f.group) continue;
    if (passes && last.from != from) continue;
    last.to = to;
    last_row = index;
    return;
  }
  std::erase_if(lasting_, [&](const Lasting& l) { return l.last_row + 1 < index; });
  lasting_.push_back({index, flags_.size(), f.group});
  flags_.push_back({kind, from, to, flag_text(f, model_, units_)});
}

void MotionRecorder::flag_failures(const CheckedSummary& summary) {
  for (const Gap& gap : summary.gaps) {
    Flag& flag = flags_.emplace_back(Flag::Kind::failed, gap.from, gap.to,
                                     failure_text(failure_of(gap, summary), model_, units_));
    const int constraint =
        gap.assembly_error ? gap.assembly_error->constraint : gap.failure.constraint;
    if (constraint >= 0) flag.open = model_.constraints[constraint].operands;
  }
}

}  // namespace desmo::cli
