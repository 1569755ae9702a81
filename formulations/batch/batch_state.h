#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "formulations/base/index_range.h"
#include "formulations/base/lane_values.h"
#include "formulations/prediction/predictor.h"

namespace desmo {

/// Copies number i of a state with its rates to number j of another; either may be in lanes.
void copy_number(const auto& from, std::size_t i, auto& to, std::size_t j) {
  to.q[j] = from.q[i];
  to.qd[j] = from.qd[i];
  to.qdd[j] = from.qdd[i];
}

/// The state of a batch at the last two instants, the lanes of each number side by side, and the
/// prediction of the next.
class BatchState {
 public:
  BatchState() = default;
  /// numbers: of one lane. predicted, unwrapped: those of them that solvers start from (see
  /// PartInputs), ascending.
  BatchState(std::size_t numbers, std::size_t lanes, Guess guess, std::span<const int> predicted,
             std::vector<int> unwrapped)
      : states_(std::make_unique<std::array<LaneState, 2>>()),
        now_(&states_->front()),
        before_(&states_->back()),
        lanes_(lanes),
        unwrapped_(std::move(unwrapped)) {
    std::vector<IndexRange> ranges = ranges_of(predicted);
    for (IndexRange& range : ranges)
      range = {range.first * static_cast<int>(lanes), range.end * static_cast<int>(lanes)};
    predictor_ = Predictor(guess, std::move(ranges));
    for (LaneState* s : {now_, before_})
      for (LaneValues* values : {&s->q, &s->qd, &s->qdd}) values->resize(numbers * lanes);
  }

  LaneState& now() { return *now_; }
  const LaneState& now() const { return *now_; }
  LaneState& before() { return *before_; }
  const LaneState& before() const { return *before_; }

  /// Leaves the last instant in before() and writes to now() the positions that solvers start from;
  /// the rest of now() is of the instant before.
  void predict(const StepHistory& history) {
    std::swap(now_, before_);
    if (!predictor_.empty()) predictor_(history, *before_, *now_, now_->q.data());
    for (const int n : unwrapped_)
      std::copy_n(&before_->q[n * lanes_], lanes_, &now_->q[n * lanes_]);
  }

 private:
  std::unique_ptr<std::array<LaneState, 2>> states_;  // these two, in turn
  LaneState *now_ = nullptr, *before_ = nullptr;
  std::size_t lanes_ = 0;
  Predictor predictor_;
  std::vector<int> unwrapped_;
};

}  // namespace desmo
