#pragma once

#include <memory>
#include <vector>

#include "formulations/base/part.h"
#include "formulations/equations/symbolic.h"

namespace desmo {

/// A group or block solved by generated code throughout: equations, elimination in up to three
/// pivot orders fixed at generation time, and substitution. The step is left to `fallback`, which
/// pivots, where Newton's method converges in none of these orders or each has too small pivots for
/// rates (PartCounts::fallbacks).
class InlinedPart final : public Part {
 public:
  /// weights: 1/magnitude of each equation (see magnitudes.h).
  InlinedPart(BoundKernel bound, std::vector<double> weights, const PartSettings& settings,
              std::unique_ptr<Part> fallback, std::vector<int> unknowns);

  PartResult solve(State& state, std::span<const double> last, Level level) override;

  void forget() override {
    fallbacks_before_ = fallbacks_;
    fallback_->forget();
  }
  void end_assembly() override { fallbacks_ = fallbacks_before_; }

  PartCounts counts() const override {
    return {.refactorisations = fallbacks_, .fallbacks = fallbacks_};
  }

 private:
  /// Makes one more iteration, in the first pivot order. iterations: number of those before it.
  InlinedResult once_more(State& state, int iterations) const;

  BoundKernel bound_;
  std::vector<double> weights_;
  int max_iterations_;
  double stop2_, accept2_;  // squares of PartSettings::stop and accept
  bool at_rounding_;
  std::unique_ptr<Part> fallback_;
  std::vector<int> unknowns_;
  std::vector<double> start_;                  // unknowns at the start of the step
  long fallbacks_ = 0, fallbacks_before_ = 0;  // now, and at the last forget()
};

}  // namespace desmo
