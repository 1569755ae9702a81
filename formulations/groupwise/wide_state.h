#pragma once

#include <vector>

namespace desmo {

/// The state of a model, in any scalar: q, q̇ and q̈ of its coordinates, then of fixed entities.
template <class S>
struct WideState {
  std::vector<S> q, qd, qdd;

  explicit WideState(int size) : q(size, S(0)), qd(size, S(0)), qdd(size, S(0)) {}
};

}  // namespace desmo
