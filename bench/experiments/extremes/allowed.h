#pragma once

#include "bench/experiments/extremes/verification.h"

namespace desmo::extremes {

/// How wrong the answers of an attempt may be: what the case's bound makes of floors and
/// yardsticks. All must outlive it.
class Allowed {
 public:
  Allowed(const Problem& problem, const Attempt& attempt, const Yardsticks& yardsticks);

  /// Of answers `part`, of the compared instant `next`.
  double operator()(Level level, std::size_t part, std::size_t next) const;

 private:
  const Problem& problem_;
  const Attempt& attempt_;
  PerLevel<double> measured_;  // the largest error of the yardstick, if the bound has one
};

}  // namespace desmo::extremes
