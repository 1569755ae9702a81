#pragma once

#include <algorithm>
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
      : limit_(limit), max_kept_(max_kept) {
    kept_.reserve(std::min<std::size_t>(max_kept, 256));
  }

  void add(Degradation degradation) {
    if (kept_.size() == max_kept_) {
      ++others_;
      return;
    }
    for (const Level l : all_levels) degradation.assessment.bound[l] /= share_[l];
    kept_.push_back(degradation);
  }
  /// Forgets an instant that is solved again, if it was the last one added.
  void take_back(int index) {
    if (others_ == 0 && !kept_.empty() && kept_.back().index == index) kept_.pop_back();
  }
  /// Converts all bounds to grown scales.
  void rescale(const Scales& from, const Scales& to) { desmo::rescale(share_, from, to); }

  /// Returns the number of instants that still exceed the limit.
  long count() const {
    return others_ + std::ranges::count_if(
                         kept_, [&](const Degradation& d) { return exceeds(bound(d), limit_); });
  }
  std::optional<Degradation> first() const {
    for (Degradation d : kept_) {
      d.assessment.bound = bound(d);
      if (exceeds(d.assessment.bound, limit_)) return d;
    }
    return {};
  }

 private:
  PerLevel<double> bound(const Degradation& d) const {
    PerLevel<double> result = d.assessment.bound;
    for (const Level l : all_levels) result[l] *= share_[l];
    return result;
  }

  PerLevel<double> share_{1, 1, 1};  // of bounds in the first scales, what they are now
  PerLevel<double> limit_;
  std::size_t max_kept_;
  std::vector<Degradation> kept_;
  long others_ = 0;
};

}  // namespace desmo
