#pragma once

#include <memory>
#include <span>
#include <vector>

#include "formulations/base/observer.h"
#include "formulations/model/model.h"
#include "formulations/scaling/scales.h"
#include "formulations/verification/certificate/certificate.h"

namespace desmo {

/// Proven error bounds of outputs, where the Assessor's are too wide: they hold for any signs of
/// all roundings, a proof for those that happened. A proof costs more than an assessment.
class CertifiedBounds {
 public:
  /// levels, asked: the levels up to which each coordinate is solved, and is an output. All must
  /// outlive this object.
  CertifiedBounds(const Model& model, std::span<const Level> levels, std::span<const Level> asked)
      : model_(model), levels_(levels), asked_(asked) {}

  /// Returns bounds as an Assessment's; infinity where there is no proof, 0 at levels that the
  /// instant does not have. The first call allocates.
  PerLevel<double> operator()(const Instant& instant, const Scales& scales);

 private:
  const Model& model_;
  std::span<const Level> levels_, asked_;
  std::unique_ptr<Certifier> certifier_;
};

}  // namespace desmo
