#pragma once

#include <Eigen/Core>
#include <vector>

#include "formulations/modelling/independence/group_system.h"

namespace desmo {

/// Φ and Φ_q of a group's candidates, in columns of natural magnitude; rows have length 1 over all
/// that they read. The magnitude of points and distances is the power of two next to their
/// characteristic length, that of all else 1: the same in every unit and beside parts of any size.
struct Linearisation {
  Eigen::VectorXd phi;
  Eigen::MatrixXd jacobian;
};

/// Linearises the systems of a mechanism's groups.
class Lineariser {
 public:
  /// The mechanism must outlive it; its constraints may change.
  explicit Lineariser(const Model& model);

  Linearisation at(const std::vector<double>& state, const GroupSystem& system);

  /// Adds a step, in columns of natural magnitude, to the state.
  void move(std::vector<double>& state, const GroupSystem& system,
            const Eigen::VectorXd& step) const;

 private:
  const Model& m_;
  std::vector<double> scale_;  // natural magnitude of each component of the state
  std::vector<int> column_;    // of each component in the system at hand, or -1
};

}  // namespace desmo
