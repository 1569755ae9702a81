#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "formulations/base/part.h"
#include "formulations/base/settings.h"
#include "formulations/equations/automatic.h"
#include "formulations/model/magnitudes.h"
#include "formulations/model/model.h"
#include "formulations/model/partition.h"

namespace desmo {

/// The equations of one group with dense matrices, for diagnosis: thorough, not fast. States have
/// Model::state_size() values.
class DenseGroup {
 public:
  /// The model outlives it.
  DenseGroup(const Model& model, const PartDefinition& group, const Magnitudes& magnitudes);

  const std::vector<int>& unknowns() const { return equations_.pattern().unknowns; }
  const Eigen::VectorXd& weights() const { return weights_; }  ///< 1/magnitude of each equation
  Eigen::VectorXd residual(const std::vector<double>& state) const;  ///< Φ
  Eigen::MatrixXd jacobian(const std::vector<double>& state) const;  ///< Φ_φ

  /// Solves the positions of its unknowns in `state`. Returns the row that stopped it; -1: solved.
  int solve(std::vector<double>& state, const Settings& settings) const;

 private:
  AutomaticEquations equations_;
  Eigen::VectorXd weights_;
};

/// Returns the row of the component of largest magnitude, or of the first one that is NaN.
int worst_row(const Eigen::VectorXd& v);

/// Group and constraint at which a step failed; no_position: unknown.
struct Culprit {
  GroupId group = no_position;
  int constraint = no_position;  ///< position in Model::constraints
};

/// Finds the group that stopped a part, whatever solved the part. Solves the groups again, one
/// after the other, from the positions at which the step began. The first group that does not
/// converge or is singular is the culprit. Its constraint is the one violated most where the group
/// stopped or, where it is singular, the one most involved in the dependence. Both are unknown
/// where all groups converge. Allocates: not for timed code. state: (Model::state_size()), with
/// drivers and earlier parts as at the failed instant.
Culprit find_culprit(const Model& model, std::span<const GroupId> groups, std::vector<double> state,
                     const Settings& settings);

}  // namespace desmo
