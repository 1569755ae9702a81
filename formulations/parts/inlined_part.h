#pragma once

#include <memory>
#include <vector>

#include "formulations/equations/symbolic.h"
#include "formulations/parts/guarded_part.h"

namespace desmo {

/// A group solved by generated code throughout: equations, elimination in a pivot order fixed
/// at generation time, and substitution. When a pivot turns out too small, or the iterations do
/// not converge, the step is left to `fallback`, which pivots; fallbacks() counts these steps.
class InlinedPart final : public GuardedPart {
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

  long fallbacks() const override { return fallbacks_; }
  void correct_once_more(bool asked) override;

 private:
  InlinedResult once_more(State& state, int iterations) const;

  BoundKernel bound_;
  std::vector<double> weights_;
  double tolerance2_;  // on ‖Φ‖₂²: where to stop iterating …
  int max_iterations_;
  double accepted2_;         // largest ‖Φ‖₂² that is accepted
  bool at_rounding_;         // see PartSettings
  double corrected_above2_;  // ‖Φ‖₂² at the tolerance that is worth one more correction
  std::unique_ptr<Part> fallback_;
  std::vector<int> unknowns_;
  std::vector<double> start_;                  // unknowns at the start of the step
  long fallbacks_ = 0, fallbacks_before_ = 0;  // before_: the assembly that has begun
};

}  // namespace desmo
