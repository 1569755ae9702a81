#pragma once

#include "formulations/base/part.h"

namespace desmo {

/// A part, such as a pivoting fallback, that forwards solve() to a part of another formulation.
class Borrowed : public Part {
 public:
  explicit Borrowed(Part& part) : part_(part) {}
  PartResult solve(State& s, std::span<const double> last, Level level) override {
    return part_.solve(s, last, level);
  }

 private:
  Part& part_;
};

}  // namespace desmo
