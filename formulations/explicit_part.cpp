#include "formulations/explicit_part.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace desmo {

namespace {

/// The equations of definitions carry on what is left in those of a core; that it be no more than
/// the tolerance costs less than an iteration.
constexpr double core_share = 1.0 / 8;

}  // namespace

ExplicitPart::ExplicitPart(const ExplicitKernel& kernel, const BoundKernel& bound,
                           std::vector<double> weights, const Settings& settings,
                           std::unique_ptr<Part> fallback)
    : kernel_(kernel),
      inputs_(bound.inputs),
      constants_(bound.constants),
      folded_(kernel.folded),
      weights_(std::move(weights)),
      branch_(kernel.branches.size(), 0.0),
      branch_before_(branch_.size()),
      tolerance_(settings.tolerance),
      fallback_(std::move(fallback)) {
  const double tolerance2 = settings.tolerance * settings.tolerance;
  const ExplicitLimits limits =
      settings.fixed_iterations > 0
          ? ExplicitLimits{std::numeric_limits<double>::infinity(), 0, settings.fixed_iterations}
          : ExplicitLimits{tolerance2, core_share * core_share * tolerance2,
                           settings.max_iterations};
  binding_ = {inputs_.data(), constants_.data(), folded_.data(),
              branch_.data(), weights_.data(),   limits};
  kernel_.fold(constants_.data(), folded_.data());
}

PartResult ExplicitPart::solve(State& s, Level level) {
  if (!assembled_) return fall_back(s, level);
  ExplicitKernel::Solve* const kernel = level == Level::position   ? kernel_.position
                                        : level == Level::velocity ? kernel_.velocity
                                                                   : kernel_.acceleration;
  const ExplicitResult<double> r = kernel(s.q.data(), s.qd.data(), s.qdd.data(), binding_);
  if (r.accepted) return {Status::converged, r.iterations, std::sqrt(r.residual2)};

  ++fallbacks_;
  std::ranges::copy(branch_, branch_before_.begin());
  const PartResult result = fall_back(s, level);
  branch_changes_ += branch_ != branch_before_;
  return result;
}

void ExplicitPart::forget() {
  assembled_ = false;
  fallback_->forget();
}

PartResult ExplicitPart::fall_back(State& s, Level level) {
  const PartResult result = fallback_->solve(s, level);
  // After a fixed number of iterations a position may still be on its way to a branch.
  if (result.status == Status::converged && result.residual < tolerance_) {
    kernel_.find_branches(s.q.data(), inputs_.data(), constants_.data(), branch_.data());
    assembled_ = true;
  }
  return result;
}

}  // namespace desmo
