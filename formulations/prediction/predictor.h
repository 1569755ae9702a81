#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "formulations/prediction/guess.h"
#include "formulations/prediction/rate_history.h"

namespace desmo {

/// Where solvers start: the guess that is wanted for some coordinates or, where the past does not
/// allow it, the best that it does (best_guess). Asked once for every step.
class Predictor {
 public:
  Predictor() = default;  ///< of no coordinate
  /// runs: of coordinates, ascending.
  Predictor(Guess wanted, std::vector<IndexRange> runs) : wanted_(wanted), runs_(std::move(runs)) {
    if (wanted_ == Guess::adams8) history_.emplace(runs_);
  }

  /// As Extrapolation: writes where the coordinates are expected into q, which may be that of
  /// `last` or of `before`. Of an instant more than one step ago it knows what was `last` then.
  template <class States>
  void operator()(const StepHistory& history, const States& last, const States& before, double* q) {
    if (history_) {
      if (history.before != Level::acceleration) history_->forget();
      if (history.last == Level::acceleration &&
          history_->predict(history.h_before, history.h, last.q.data(), last.qd.data(),
                            last.qdd.data(), q))
        return;
    }
    Extrapolation(best_guess(wanted_, history), history)(runs_, last, before, q);
  }

  bool empty() const { return runs_.empty(); }

 private:
  Guess wanted_ = Guess::previous;
  std::vector<IndexRange> runs_;
  std::optional<RateHistory> history_;  // where the guess needs more than two instants
};

}  // namespace desmo
