#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "formulations/base/index_range.h"
#include "formulations/base/part.h"

namespace desmo {

/// Returns the name of a guess in ids: "previous", "linear", "quadratic", "hermite3", "hermite5",
/// "adams8".
std::string_view guess_name(Guess guess);
/// Returns the names of all guesses, in the order of Guess.
std::vector<std::string_view> guess_names();

/// Limit of the ratio of a step to the one before it (<). At and above it, the last instant alone
/// predicts the step. At 4 the quintic of hermite5 magnifies errors of positions 10,000 times, and
/// at 10 a million times.
inline constexpr double max_step_growth = 4;

/// Knowledge of a predictor about the last instant and the one before it.
struct StepHistory {
  double h;         ///< time from the last instant to the predicted one [s]
  double h_before;  ///< time from the instant before to the last one [s]
  /// levels to which the last instant and the one before were solved; nothing: unknown
  std::optional<Level> last, before{};

  /// Returns the history of coordinates that are solved no higher than this level.
  StepHistory up_to(Level level) const {
    if (level == Level::acceleration) return *this;
    const auto cut = [&](std::optional<Level> l) { return l ? std::min(*l, level) : l; };
    return {h, h_before, cut(last), cut(before)};
  }
};

/// Returns the best guess that the history allows, in the order previous, linear, quadratic,
/// hermite3, hermite5, and at most the one wanted. Only `last` counts where the two instants are
/// much closer together than the step is long (max_step_growth): their difference is mostly
/// rounding.
Guess best_guess(Guess wanted, const StepHistory& history);

/// The prediction of a step by a guess, as a weighted sum. The weights are computed once a step;
/// each coordinate then takes a few operations. With the last instant as number 1 and the one
/// before it as number 0:
///   q = q₁ + w_q (q₀ − q₁) + w_v1 q̇₁ + w_a1 q̈₁ + w_v0 q̇₀ + w_a0 q̈₀.
class Prediction {
 public:
  /// guess: one that the history allows (best_guess).
  Prediction(Guess guess, const StepHistory& history);

  /// Writes the predicted coordinates of some ranges into q, which may be the q of `last` or
  /// `before`. last, before: states in single numbers or in lanes; only what the guess needs of
  /// them is read.
  template <class States>
  void operator()(std::span<const IndexRange> ranges, const States& last, const States& before,
                  double* q) const;

 private:
  Guess guess_;
  double w_q_ = 0, w_v1_ = 0, w_a1_ = 0, w_v0_ = 0, w_a0_ = 0;
};

template <class States>
void Prediction::operator()(std::span<const IndexRange> ranges, const States& last,
                            const States& before, double* q) const {
  const double *q1 = last.q.data(), *v1 = last.qd.data(), *a1 = last.qdd.data();
  const double *q0 = before.q.data(), *v0 = before.qd.data(), *a0 = before.qdd.data();
  const double w_q = w_q_, w_v1 = w_v1_, w_a1 = w_a1_, w_v0 = w_v0_, w_a0 = w_a0_;
  // Many ranges are single coordinates, for which a loop on wide registers takes long to begin.
  const auto write = [&](auto expected) {
    for (const IndexRange range : ranges) {
      if (range.end - range.first == 1) {
        q[range.first] = expected(range.first);
        continue;
      }
#pragma GCC ivdep  // q overlaps no array that is read, or is one of them
      for (int i = range.first; i < range.end; ++i) q[i] = expected(i);
    }
  };
  switch (guess_) {
    case Guess::previous:
      return write([=](int i) { return q1[i]; });
    case Guess::linear:
      return write([=](int i) { return q1[i] + w_v1 * v1[i]; });
    case Guess::quadratic:
      return write([=](int i) { return q1[i] + w_v1 * v1[i] + w_a1 * a1[i]; });
    case Guess::hermite3:
      return write(
          [=](int i) { return q1[i] + w_q * (q0[i] - q1[i]) + w_v1 * v1[i] + w_v0 * v0[i]; });
    case Guess::hermite5:
      return write([=](int i) {
        return q1[i] + w_q * (q0[i] - q1[i]) + w_v1 * v1[i] + w_v0 * v0[i] + w_a1 * a1[i] +
               w_a0 * a0[i];
      });
    case Guess::adams8:
      return;  // it needs more instants: see RateHistory
  }
}

}  // namespace desmo
