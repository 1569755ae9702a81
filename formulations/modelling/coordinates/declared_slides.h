#pragma once

#include <array>
#include <set>

#include "cases/mechanism/mechanism.h"

namespace desmo {

/// The distances along sliding joints that a description declares.
class DeclaredSlides {
 public:
  explicit DeclaredSlides(const Mechanism& mechanism);
  /// Whether a joint slides, so that a distance along it can define it.
  static bool slides(const Mechanism::Joint& joint);
  /// Whether its distance is declared.
  bool contain(const Mechanism::Joint& joint) const;

 private:
  std::set<std::array<int, 3>> declared_;  // vector, and the points in ascending order
};

}  // namespace desmo
