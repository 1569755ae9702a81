#pragma once

#include <optional>
#include <vector>

#include "formulations/verification/assessment/assessment.h"
#include "formulations/verification/assessment/limits.h"

namespace desmo {

/// List of a motion's degraded instants. Bounds are relative to the motion so far. So an instant
/// may leave the list when rates grow, for instance after a start from rest.
class Degradations {
 public:
  /// limit: above which a bound makes an instant degraded. max_kept: instants that follow the
  /// scales; the others stay as they were found.
  Degradations(const PerLevel<double>& limit, std::size_t max_kept)
      : limit_(limit), max_kept_(max_kept) {}

  void add(const Degradation& degradation) {
    if (kept_.size() < max_kept_)
      kept_.push_back(degradation);
    else
      ++others_;
  }
  /// Converts all bounds to grown scales, and removes instants that no longer exceed the limit.
  void rescale(const Scales& from, const Scales& to) {
    for (Degradation& d : kept_) desmo::rescale(d.assessment.bound, from, to);
    std::erase_if(kept_,
                  [&](const Degradation& d) { return !exceeds(d.assessment.bound, limit_); });
  }

  long count() const { return static_cast<long>(kept_.size()) + others_; }
  std::optional<Degradation> first() const {
    return kept_.empty() ? std::nullopt : std::optional(kept_.front());
  }

 private:
  PerLevel<double> limit_;
  std::size_t max_kept_;
  std::vector<Degradation> kept_;
  long others_ = 0;
};

}  // namespace desmo
