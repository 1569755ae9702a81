#pragma once

#include <vector>

namespace desmo {

/// q, q̇ and q̈ of a whole model, each followed by the fixed entities, in any scalar.
template <class S>
struct WideState {
  std::vector<S> q, qd, qdd;

  explicit WideState(int size) : q(size, S(0)), qd(size, S(0)), qdd(size, S(0)) {}
};

}  // namespace desmo
