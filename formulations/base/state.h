#pragma once

#include <vector>

namespace desmo {

/// The state (q, then the components of the fixed entities) and its time derivatives; those of
/// the fixed entities are zero. All three have Model::state_size() components.
struct State {
  std::vector<double> q, qd, qdd;
};

}  // namespace desmo
