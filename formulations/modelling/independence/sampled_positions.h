#pragma once

#include <Eigen/Core>
#include <array>
#include <tuple>
#include <vector>

#include "formulations/modelling/independence/linearisation.h"

namespace desmo {

/// The states at which the dependence of equations is judged: the nominal position, then two
/// perturbed ones.
using SampledPositions = std::array<std::vector<double>, 3>;

/// The linearisers of a model: by the longest lengths and, where these hide small bodies on large
/// ones, by the shortest.
struct Linearisers {
  explicit Linearisers(const Model& model)
      : usual(model), of_small(model, Lineariser::Lengths::shortest) {}
  Lineariser usual, of_small;
};

/// Assembles these positions. Each group may move its unknowns and its drivers. A perturbed
/// position that cannot be assembled is replaced by the nominal one. Some redundant groups can be
/// assembled, or follow their drivers, only with misfits up to max_misfit. Sets their
/// GroupSystem::dependent_below to that. Throws std::invalid_argument, naming group, bodies and
/// constraint, when the nominal position cannot be assembled.
SampledPositions assemble_positions(const Model& model, std::vector<GroupSystem>& systems,
                                    Linearisers& linearisers);

/// Scaled Jacobians of all rows (rows × columns), at each sampled position.
using SampledJacobians = std::array<Eigen::MatrixXd, std::tuple_size_v<SampledPositions>>;

/// Evaluates the Jacobians of a group.
SampledJacobians sample_jacobians(const GroupSystem& system, const SampledPositions& positions,
                                  Linearisers& linearisers);

/// Returns the freedoms that the candidates leave to a group, drivers free, at the most general
/// position.
int mobility(const GroupSystem& system, const SampledJacobians& jacobians);

}  // namespace desmo
