#pragma once

#include <Eigen/Core>
#include <vector>

#include "formulations/modelling/independence/group_system.h"

namespace desmo {

/// Scaled Φ and Φ_q of a group's candidates. Columns are multiplied by natural magnitudes: for
/// points and distances the power of two next to their characteristic length, else 1. Rows are
/// divided by their norm over all variables that the equation reads. The result does not depend on
/// units.
struct Linearisation {
  Eigen::VectorXd phi;       ///< (rows)
  Eigen::MatrixXd jacobian;  ///< (rows × columns) of the GroupSystem
};

/// A lineariser of the group systems of a model.
class Lineariser {
 public:
  /// Finds the natural magnitudes. The model must outlive the object; its constraints may change.
  explicit Lineariser(const Model& model);

  Linearisation at(const std::vector<double>& state, const GroupSystem& system);

  /// Adds a step, given in natural magnitudes of the system's columns, to the state.
  void move(std::vector<double>& state, const GroupSystem& system,
            const Eigen::VectorXd& step) const;

 private:
  const Model& m_;
  std::vector<double> scale_;  // natural magnitude of each component of the state
  std::vector<int> column_;    // column of each component in the current system, or -1
};

}  // namespace desmo
