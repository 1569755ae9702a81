#include "formulations/verification/range/locked_loops.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <span>

#include "formulations/model/characteristic_lengths.h"
#include "formulations/model/part_system.h"

namespace desmo {

namespace {

using Eigen::MatrixXd;
/// Decomposition whose small singular values are as exact as the large ones.
using Decomposition = Eigen::JacobiSVD<MatrixXd, Eigen::NoQRPreconditioner>;

/// Returns Φ_φ of a block, with columns times lengths and rows over their sums.
MatrixXd scaled_jacobian(const Model& m, const PartDefinition& block,
                         std::span<const double> lengths, std::span<const double> state) {
  ScalarState<double> at(m.state_size());
  std::ranges::copy(state, at.q.begin());
  const PartSystem<double> system(m, block, at);
  const auto n = static_cast<Eigen::Index>(system.n);
  MatrixXd jacobian = MatrixXd::Map(system.jacobian.data(), n, n).transpose();  // stored by rows
  for (Eigen::Index j = 0; j < n; ++j) jacobian.col(j) *= lengths[block.unknowns[j]];
  for (Eigen::Index i = 0; i < n; ++i)
    if (const double sum = jacobian.row(i).lpNorm<1>(); sum > 0) jacobian.row(i) /= sum;
  return jacobian;
}

void add(std::vector<int>& list, int element) {
  if (std::ranges::find(list, element) == list.end()) list.push_back(element);
}

}  // namespace

LockedLoops find_locked_loops(const Model& m, const SolutionCurve& curve,
                              const SolutionCurve::Point& before,
                              const SolutionCurve::Point& point) {
  const std::vector<EntityId> owner = entity_of_coordinate(m);
  const std::vector<double> lengths = CharacteristicLengths(m).of_coordinates();
  LockedLoops locked;
  for (const PartDefinition& block : curve.blocks()) {
    const Decomposition here(scaled_jacobian(m, block, lengths, point.state), Eigen::ComputeFullV);
    const Decomposition there(scaled_jacobian(m, block, lengths, before.state));
    const Eigen::Index n = here.singularValues().size();
    Eigen::Index nullity = 0;
    for (; nullity < n; ++nullity) {
      const double left =
          here.singularValues()[n - 1 - nullity] / there.singularValues()[n - 1 - nullity];
      if (!(left < 0.5)) break;
      locked.left = std::max(locked.left, left);
    }
    if (nullity == 0) continue;
    for (const GroupId group : block.groups) add(locked.groups, group);
    // Vectors of equal singular values are not unique, but the norms of rows of all of them are.
    const Eigen::VectorXd change = here.matrixV().rightCols(nullity).rowwise().norm();
    for (Eigen::Index j = 0; j < n; ++j)
      if (change[j] > curve.limits().locking_arc() * change.maxCoeff())
        add(locked.moving, owner[block.unknowns[j]]);
  }
  return locked;
}

LockedLoops first_locked_loop(const Model& m, const SolutionCurve& curve,
                              const SolutionCurve::Point& point) {
  const std::vector<EntityId> owner = entity_of_coordinate(m);
  LockedLoops locked;
  for (const PartDefinition& block : curve.blocks()) {
    for (const int i : block.unknowns) {
      const auto j = std::ranges::lower_bound(curve.unknowns(), i) - curve.unknowns().begin();
      if (std::abs(point.tangent[j]) > curve.limits().locking_arc()) add(locked.moving, owner[i]);
    }
    if (locked.moving.empty()) continue;
    locked.groups = {block.groups.front()};
    break;
  }
  return locked;
}

}  // namespace desmo
