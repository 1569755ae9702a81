#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "formulations/motion/prediction/guess.h"
#include "formulations/motion/prediction/rate_history.h"

namespace desmo {

/// A predictor of some coordinates, called once in every step. It uses the guess that is wanted,
/// or the best one that the known instants allow (best_guess).
class Predictor {
 public:
  Predictor() = default;  ///< predicts no coordinate
  /// ranges: of coordinates, ascending.
  Predictor(Guess wanted, std::vector<IndexRange> ranges)
      : wanted_(wanted), ranges_(std::move(ranges)) {
    if (wanted_ == Guess::adams8) history_.emplace(ranges_);
  }

  /// Writes the predicted coordinates into q. For adams8 the predictor itself keeps rates of
  /// earlier instants: it copies those of `last` in every call.
  /// - last, before: the last instant and the one before it; q may be the q of either
  template <class States>
  void operator()(const StepHistory& history, const States& last, const States& before, double* q) {
    if (history_) {
      if (history.before != Level::acceleration) history_->forget();
      if (history.last == Level::acceleration &&
          history_->predict(history.h_before, history.h, last.q.data(), last.qd.data(),
                            last.qdd.data(), q))
        return;
    }
    Prediction(best_guess(wanted_, history), history)(ranges_, last, before, q);
  }

  bool empty() const { return ranges_.empty(); }

 private:
  Guess wanted_ = Guess::previous;
  std::vector<IndexRange> ranges_;
  std::optional<RateHistory> history_;  // for adams8, which needs more than two instants
};

}  // namespace desmo
