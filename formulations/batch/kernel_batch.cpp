#include "formulations/batch/kernel_batch.h"

#include <algorithm>

namespace desmo {

namespace {

using Binding = ExplicitBinding<double>;

/// Returns an array of all parts in lanes: element k of each part side by side.
LaneValues side_by_side(const std::vector<ExplicitPart*>& lanes, std::size_t count,
                        const double* Binding::*array) {
  LaneValues result;
  for (std::size_t k = 0; k < count; ++k)
    for (const ExplicitPart* const part : lanes) result.push_back((part->binding().*array)[k]);
  return result;
}

/// Returns the limits of the lane with the largest tolerance: rounding floors differ between lanes.
ExplicitLimits limits_of(const std::vector<ExplicitPart*>& lanes) {
  const auto limits = [](const ExplicitPart* part) { return part->binding().limits; };
  return limits(*std::ranges::max_element(
      lanes, {}, [&](const ExplicitPart* part) { return limits(part).tolerance2; }));
}

}  // namespace

KernelBatch::KernelBatch(const LaneKernel& kernel, std::vector<ExplicitPart*> lanes,
                         std::vector<int> in)
    : kernel_(kernel), lanes_(std::move(lanes)), in_(std::move(in)) {
  const ExplicitPart& any = *lanes_.front();
  c_ = side_by_side(lanes_, any.constants(), &Binding::c);
  f_ = side_by_side(lanes_, static_cast<std::size_t>(any.kernel().folded), &Binding::f);
  w_ = side_by_side(lanes_, any.equations(), &Binding::w);
  branch_.resize(any.branches().size() * lanes_.size());
  anchors_.resize(any.kernel().angles.size() * anchor_size * lanes_.size());
  binding_ = {in_.data(), c_.data(),       f_.data(),        branch_.data(),
              w_.data(),  anchors_.data(), limits_of(lanes_)};
}

void KernelBatch::take_branches() {  // in place: nothing is allocated during a motion
  for (std::size_t l = 0; l < lanes_.size(); ++l) {
    const std::span<const double> branches = lanes_[l]->branches();
    for (std::size_t k = 0; k < branches.size(); ++k) branch_[k * lanes_.size() + l] = branches[k];
  }
  std::ranges::fill(anchors_, 0.0);
}

bool KernelBatch::assembled() const {
  return std::ranges::all_of(lanes_, &ExplicitPart::assembled);
}

}  // namespace desmo
