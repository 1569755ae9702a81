#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "formulations/base/part.h"
#include "formulations/base/settings.h"
#include "formulations/equations/automatic.h"
#include "formulations/model/model.h"
#include "formulations/scaling/magnitudes.h"
#include "formulations/structure/partition.h"

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

  /// Solves the positions of its unknowns in `state`; the row that stopped it, or -1.
  int solve(std::vector<double>& state, const Settings& settings) const;

 private:
  AutomaticEquations equations_;
  Eigen::VectorXd weights_;
};

/// The row of the largest component, or of the first that is not a number.
int worst_row(const Eigen::VectorXd& v);

/// Group and constraint at which a step failed; -1: unknown.
struct Culprit {
  GroupId group = -1;
  int constraint = -1;  ///< position in Model::constraints
};

/// Finds the group that stopped a part, whatever solved it: the groups are solved again one after
/// the other, from the positions at which the step began, and the first that does not converge,
/// or is singular, is the culprit. Its constraint is the one worst satisfied where it stopped or,
/// if singular, the one most involved in the dependence. Not for timed code: it allocates.
/// state: Model::state_size() values, drivers and earlier parts as of the failed instant.
Culprit find_culprit(const Model& model, std::span<const GroupId> groups, std::vector<double> state,
                     const Settings& settings);

}  // namespace desmo
