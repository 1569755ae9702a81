#pragma once

#include <cstddef>
#include <vector>

namespace desmo {

/// The state (q, then the components of the fixed entities) and its time derivatives; those of
/// the fixed entities are zero. Of a model, all three have Model::state_size() components.
struct State {
  std::vector<double> q, qd, qdd;

  /// Gives all three this size; new components are 0.
  void resize(std::size_t size) {
    for (std::vector<double>* values : {&q, &qd, &qdd}) values->resize(size);
  }
};

}  // namespace desmo
