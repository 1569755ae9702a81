#pragma once

#include <Eigen/Core>
#include <vector>

#include "formulations/base/settings.h"
#include "formulations/equations/automatic.h"
#include "formulations/scaling/magnitudes.h"
#include "formulations/structure/partition.h"

namespace desmo {

/// The equations of one group with dense matrices, for diagnosis: thorough, not fast. States have
/// Model::state_size() values.
class DenseGroup {
 public:
  /// The mechanism must outlive it.
  DenseGroup(const Model& model, const PartDefinition& group, const Magnitudes& magnitudes);

  const std::vector<int>& unknowns() const { return equations_.pattern().unknowns; }
  const Eigen::VectorXd& weights() const { return weights_; }  ///< 1/magnitude of each equation
  Eigen::VectorXd residual(const std::vector<double>& state) const;  ///< Φ
  Eigen::MatrixXd jacobian(const std::vector<double>& state) const;  ///< Φ_φ

  /// Solves the positions of its unknowns in `state`; the row that stopped it, or -1.
  int solve(std::vector<double>& state, const Settings& settings) const;

 private:
  AutomaticEquations equations_;
  Eigen::VectorXd weights_;
};

/// The row of the largest component, or of the first that is not a number.
int worst_row(const Eigen::VectorXd& v);

}  // namespace desmo
