#include "formulations/parts/inlined_part.h"

namespace desmo {

InlinedPart::InlinedPart(BoundKernel bound, std::vector<double> weights,
                         const PartSettings& settings, std::unique_ptr<Part> fallback,
                         std::vector<int> unknowns)
    : bound_(std::move(bound)),
      weights_(std::move(weights)),
      max_iterations_(settings.max_iterations),
      stop2_(settings.stop * settings.stop),
      accept2_(settings.accept * settings.accept),
      at_rounding_(settings.at_rounding),
      fallback_(std::move(fallback)),
      unknowns_(std::move(unknowns)),
      start_(unknowns_.size()) {}

/// Not inlined: every step would have to save the registers that this function needs.
[[gnu::noinline]] InlinedResult InlinedPart::once_more(State& s, int iterations) const {
  InlinedResult position = bound_.kernel->position(s.q.data(), bound_.inputs.data(),
                                                   bound_.constants.data(), weights_.data(), 0, 1);
  position.iterations += iterations;
  return position;
}

PartResult InlinedPart::solve(State& s, std::span<const double> last, Level level) {
  const int* in = bound_.inputs.data();
  const double* c = bound_.constants.data();
  for (std::size_t i = 0; i < unknowns_.size(); ++i) start_[i] = s.q[unknowns_[i]];

  InlinedResult position =
      bound_.kernel->position(s.q.data(), in, c, weights_.data(), stop2_, max_iterations_);
  if (at_rounding_ && position.residual2 < stop2_) [[unlikely]]
    position = once_more(s, position.iterations);
  bool good = position.residual2 < accept2_;  // false for NaN, too
  if (good && level != Level::position) {
    double* acc = level == Level::acceleration ? s.qdd.data() : nullptr;
    good = bound_.kernel->rates(s.q.data(), s.qd.data(), acc, in, c);
  }
  if (good) return {Status::solved, position.iterations, position.residual2};

  ++fallbacks_;
  for (std::size_t i = 0; i < unknowns_.size(); ++i) s.q[unknowns_[i]] = start_[i];
  return fallback_->solve(s, last, level);
}

}  // namespace desmo
