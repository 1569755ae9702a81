#include "formulations/verification/error.h"

#include <algorithm>
#include <cmath>

namespace desmo {

ErrorMeasure::ErrorMeasure(const Model& m, std::span<const ReferenceInstant> reference,
                           const Scales& scales, std::span<const Output> outputs)
    : reference_(reference) {
  const auto add = [&](const Entity& e, Level level) {
    if (e.fixed) return;
    Compared o{e.first, e.size, level, {}};
    for (const Level l : all_levels) o.scale[l] = scales.of(e.kind, l);
    compared_.push_back(o);
  };
  for (const auto& [id, level] : outputs) add(m.entities[id], level);
  if (outputs.empty())
    for (const Entity& e : m.entities) add(e, Level::acceleration);
}

Flow ErrorMeasure::observe(const Instant& instant) noexcept {
  while (next_ < reference_.size() && reference_[next_].time < instant.time) ++next_;
  if (next_ == reference_.size() || reference_[next_].time != instant.time) return Flow::go_on;
  const ReferenceInstant& r = reference_[next_++];
  ++so_far_.instants;
  compare(Level::position, instant.q, r.q, r.remainder.q);
  compare(Level::velocity, instant.qd, r.qd, r.remainder.qd);
  compare(Level::acceleration, instant.qdd, r.qdd, r.remainder.qdd);
  return Flow::go_on;
}

void ErrorMeasure::compare(Level level, std::span<const double> found,
                           std::span<const double> reference, std::span<const double> remainder) {
  if (found.empty()) return;  // beyond the level requested
  for (const Compared& o : compared_) {
    if (o.level < level) continue;
    double squares = 0;
    for (int i = o.first; i < o.first + o.size; ++i) {
      // Doubles within a factor of two subtract exactly, so that the remainder still counts.
      const double difference = (found[i] - reference[i]) - (remainder.empty() ? 0 : remainder[i]);
      const double error = relative(difference, o.scale[level]);
      squares += error * error;
    }
    LevelError& sum = so_far_[level];
    const double error = std::sqrt(squares);  // no NaN: relative() returns none
    sum.max = std::max(sum.max, error);
    sum.rms += error * error;
    ++sum.compared;
  }
}

SolutionError ErrorMeasure::error() const {
  SolutionError e = so_far_;
  for (const Level level : all_levels) {
    auto& [max, rms, compared] = e[level];
    if (compared > 0) rms = std::isinf(max) ? max : std::sqrt(rms / static_cast<double>(compared));
  }
  return e;
}

}  // namespace desmo
