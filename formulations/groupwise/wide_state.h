#pragma once

#include <vector>

namespace desmo {

/// q, q̇ and q̈ of a whole mechanism with its fixed entities behind, in any scalar.
template <class S>
struct WideState {
  std::vector<S> q, qd, qdd;

  explicit WideState(int size) : q(size, S(0)), qd(size, S(0)), qdd(size, S(0)) {}
};

}  // namespace desmo
