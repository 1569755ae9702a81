#pragma once

#include "formulations/stepping/formulation.h"

namespace desmo {

/// A sink for runs of which only the summary matters.
class Discard final : public Sink {
 public:
  void accept(const Instant&) override {}
};

}  // namespace desmo
