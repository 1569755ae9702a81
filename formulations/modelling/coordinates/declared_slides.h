#pragma once

#include <array>
#include <set>

#include "cases/mechanism/mechanism.h"

namespace desmo {

/// The set of sliding joints whose distance the mechanism declares as a coordinate.
class DeclaredSlides {
 public:
  explicit DeclaredSlides(const Mechanism& mechanism);
  /// Returns whether a joint slides (see JointForm), so that the distance along it can define it.
  static bool slides(const Mechanism::Joint& joint);
  /// Returns whether the joint's distance is declared.
  bool contain(const Mechanism::Joint& joint) const;

 private:
  std::set<std::array<int, 3>> declared_;  // vector, and the points in ascending order
};

}  // namespace desmo
