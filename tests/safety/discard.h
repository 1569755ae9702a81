#pragma once

#include "formulations/base/observer.h"

namespace desmo {

/// An observer for runs of which only the summary matters.
class Discard final : public Observer {
 public:
  void observe(const Instant&) override {}
};

}  // namespace desmo
