#include "formulations/verification/assessment/certified_bounds.h"

#include <algorithm>
#include <cmath>

namespace desmo {

PerLevel<double> CertifiedBounds::operator()(const Instant& instant, const Scales& scales) {
  if (!certifier_) certifier_ = std::make_unique<Certifier>(model_, levels_);
  const Certificate proof = certifier_->certify(instant);
  PerLevel<double> bound{};
  for (const Level level : desmo::levels) {
    if (level >= Level::velocity && instant.qd.empty()) break;
    if (level == Level::acceleration && instant.qdd.empty()) break;
    for (const Entity& e : model_.entities) {
      if (e.fixed || asked_[e.first] < level) continue;
      const double scale = scales.of(e.kind, level);
      if (!(scale > 0)) continue;
      double squares = 0;
      for (int i = e.first; i < e.first + e.size; ++i)
        squares += proof.radius[level][i] * proof.radius[level][i];
      bound[level] = std::max(bound[level], std::sqrt(squares) / scale);
    }
  }
  return bound;
}

}  // namespace desmo
