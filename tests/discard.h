#pragma once

#include "formulations/base/observer.h"

namespace desmo {

/// An observer that only counts instants, for runs whose summary alone matters.
class Discard final : public Observer {
 public:
  Flow observe(const Instant&) noexcept override {
    ++instants;
    return Flow::go_on;
  }
  int instants = 0;
};

}  // namespace desmo
