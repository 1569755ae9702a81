#pragma once

#include <string>
#include <vector>

#include "bench/peers/tree/axle.h"
#include "bench/peers/tree/moving.h"
#include "cases/mechanism/mechanism.h"

namespace desmo::tree {

/// Rod and tube of a damper, from A on the axle to T on the chassis. Relative coordinate: the
/// length s, which T − A gives.
class Damper {
 public:
  /// rod, tube: the bodies' numbers, "10" and "11".
  Damper(const Mechanism& mechanism, const std::string& prefix, const std::string& rod,
         const std::string& tube);

  /// Names of what solve() delivers, in its order.
  static std::vector<std::string> delivered(const std::string& prefix, const std::string& rod,
                                            const std::string& tube);

  void solve(const Pose& axle, AnswerWriter& out) const;

 private:
  Vec a_;  // A on the axle, from S in its frame
  Vec t_;  // T
};

}  // namespace desmo::tree
