#include "bench/cli/view/motion_recorder.h"

#include <algorithm>
#include <cmath>

#include "bench/cli/solve/run_notes.h"

namespace desmo::cli {

MotionRecorder::MotionRecorder(const Model& model, const DisplayUnits& units, const TimeGrid& grid,
                               std::size_t max_kept, bench::Progress* progress)
    : model_(model),
      units_(units),
      grid_(grid),
      max_kept_(std::max<std::size_t>(max_kept, 4)),
      progress_(progress) {}

MonitoredSummary MotionRecorder::run(Formulation& formulation) {
  MonitoredRunOptions options;
  options.past_failures = true;
  options.monitored = [this](const MonitoredInstant& instant) { record(instant); };
  const MonitoredSummary summary =
      run_monitored(formulation, grid_, {Level::acceleration}, *this, options);
  for (RecordedInstant& last : passed_) instants_.push_back(std::move(last));
  passed_.clear();
  if (instants_.empty()) {
    std::vector<double> state = model_.estimate;
    state.resize(3 * state.size());
    instants_.push_back({0, std::move(state), 0, {}});
  }
  drop_outgrown_flags(summary);
  flag_failures(summary);
  std::ranges::stable_sort(flags_, {}, &Flag::from);
  return summary;
}

Flow MotionRecorder::observe(const Instant&) noexcept {
  if (progress_) progress_->done();
  return overflowed_ ? Flow::stop : Flow::go_on;
}

void MotionRecorder::record(const MonitoredInstant& monitored) {
  const Instant& instant = monitored.instant;
  const auto n = static_cast<std::size_t>(model_.coordinates());
  std::vector<double> state;
  state.reserve(3 * n);
  for (const std::span<const double> values : {instant.q, instant.qd, instant.qdd})
    state.insert(state.end(), values.begin(), values.begin() + static_cast<std::ptrdiff_t>(n));
  overflowed_ = !std::ranges::all_of(state, [](double x) { return std::isfinite(x); });
  if (overflowed_) return;
  ++solved_;
  flag(monitored);
  condition_ = std::max(condition_, monitored.assessment.condition);
  for (const Level level : all_levels)
    bound_[level] = std::max(bound_[level], monitored.assessment.bound[level]);
  keep({instant.index, std::move(state), condition_, bound_});
}

/// Keeps every instant of the stride; holds the others until the next one comes.
void MotionRecorder::keep(RecordedInstant instant) {
  if (!passed_.empty() && passed_.back().index + 1 < instant.index)  // the last one before a gap
    instants_.push_back(std::move(passed_.back()));
  passed_.clear();
  if (instant.index % stride_ != 0) {
    passed_.push_back(std::move(instant));
    return;
  }
  instants_.push_back(std::move(instant));
  condition_ = 0;
  bound_ = {};
  if (instants_.size() > max_kept_) drop_every_second();
}

/// Doubles the stride. What is left out hands its condition and bounds to the next one kept.
void MotionRecorder::drop_every_second() {
  stride_ *= 2;
  std::vector<RecordedInstant> kept;
  for (std::size_t i = 0; i < instants_.size(); ++i) {
    RecordedInstant& instant = instants_[i];
    const bool before_gap =
        i + 1 < instants_.size() && instants_[i + 1].index > instant.index + stride_;
    condition_ = std::max(condition_, instant.condition);
    for (const Level level : all_levels)
      bound_[level] = std::max(bound_[level], instant.bound[level]);
    if (instant.index % stride_ != 0 && !before_gap) continue;
    instant.condition = std::exchange(condition_, 0);
    instant.bound = std::exchange(bound_, {});
    kept.push_back(std::move(instant));
  }
  instants_ = std::move(kept);
}

void MotionRecorder::flag(const MonitoredInstant& monitored) {
  const Instant& instant = monitored.instant;
  if (monitored.crossing) {
    const SingularityCrossing& c = *monitored.crossing;
    flags_.push_back(
        {c.kind == SingularityCrossing::Kind::passed ? Flag::Kind::crossing : Flag::Kind::branch,
         std::max(c.after, grid_.start), c.before, crossing_text(c, model_)});
  }
  if (!monitored.degraded) return;
  const auto is_degraded = [](const Flag& f) { return f.kind == Flag::Kind::degraded; };
  if (last_degraded_ + 1 == instant.index) {
    std::find_if(flags_.rbegin(), flags_.rend(), is_degraded)->to = instant.time;
  } else {
    flags_.push_back({Flag::Kind::degraded, instant.time, instant.time,
                      degradation_text({instant.index, instant.time, monitored.assessment},
                                       Level::acceleration, model_)});
  }
  last_degraded_ = instant.index;
}

/// Removes flags of instants that are not degraded compared with the whole motion: its rates have
/// grown.
void MotionRecorder::drop_outgrown_flags(const MonitoredSummary& summary) {
  const double first = summary.first_degraded ? summary.first_degraded->time : INFINITY;
  std::erase_if(flags_, [&](const Flag& flag) {
    return flag.kind == Flag::Kind::degraded && flag.to < first;
  });
}

void MotionRecorder::flag_failures(const MonitoredSummary& summary) {
  for (const Gap& gap : summary.gaps) {
    MonitoredSummary failure;
    static_cast<BasicSummary&>(failure) = gap.failure;
    failure.assembly_error = gap.assembly_error;
    Flag& flag = flags_.emplace_back(Flag::Kind::failed, gap.from, gap.to,
                                     failure_text(failure, model_, units_));
    const int constraint =
        gap.assembly_error ? gap.assembly_error->constraint : gap.failure.constraint;
    if (constraint >= 0) flag.open = model_.constraints[constraint].operands;
  }
  if (summary.violated < 0) return;
  flags_.push_back({Flag::Kind::failed, summary.time, grid_.time(grid_.instants - 1),
                    failure_text(summary, model_, units_),
                    model_.constraints[summary.violated].operands});
}

}  // namespace desmo::cli
