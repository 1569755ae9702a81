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
#include "formulations/equations/lane_kernel.h"
#include "formulations/motion/prediction/predictor.h"
#include "formulations/parts/explicit_part.h"

namespace desmo {

/// A batch of parts of one type, one in each lane, bound to a kernel for as many lanes.
class KernelBatch {
 public:
  /// - lanes: the part in each lane of the kernel, all of the kernel's type; a part may stand in
  ///   several lanes; the kernel and the parts outlive the batch
  /// - in: the position of each local input in the arrays that solve() is given
  KernelBatch(const LaneKernel& kernel, std::vector<ExplicitPart*> lanes, std::vector<int> in);
  KernelBatch(KernelBatch&&) = default;  // binding_ stays valid: moved vectors keep their memory

  /// Solves positions, velocities and accelerations in a state whose numbers are in lanes.
  /// Positions and rates of a lane that is not accepted are unspecified. residual2: (lanes), begins
  /// a cache line; overwritten by the weighted ‖Φ‖₂² of each lane.
  LaneResult solve(LaneState& state, double* residual2) const {
    return kernel_.solve(state.q.data(), state.qd.data(), state.qdd.data(), binding_, residual2);
  }

  /// Copies the branches on which the parts are now. Voids the anchors (ExplicitBinding).
  void take_branches();

  /// Returns whether every part has found a position since its forget().
  bool assembled() const;

 private:
  const LaneKernel& kernel_;
  std::vector<ExplicitPart*> lanes_;
  std::vector<int> in_;
  LaneValues c_, f_, w_, branch_, anchors_;
  ExplicitBinding<double> binding_;
};

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
  /// numbers: their count in one lane. predicted, unwrapped: the numbers that solvers start from
  /// (see PartInputs), ascending.
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
    for (LaneState* s : {now_, before_}) s->resize(numbers * lanes);
  }

  LaneState& now() { return *now_; }
  const LaneState& now() const { return *now_; }
  LaneState& before() { return *before_; }
  const LaneState& before() const { return *before_; }

  /// Leaves the last instant in before() and writes to now() the positions that solvers start from.
  /// The rest of now() is of the instant before the last.
  void predict(const StepHistory& history) {
    std::swap(now_, before_);
    if (!predictor_.empty()) predictor_(history, *before_, *now_, now_->q.data());
    for (const int n : unwrapped_)
      std::copy_n(&before_->q[n * lanes_], lanes_, &now_->q[n * lanes_]);
  }

 private:
  // memory of now_ and before_, which take turns
  std::unique_ptr<std::array<LaneState, 2>> states_;
  LaneState *now_ = nullptr, *before_ = nullptr;
  std::size_t lanes_ = 0;
  Predictor predictor_;
  std::vector<int> unwrapped_;
};

}  // namespace desmo
