#include "formulations/motion/diagnosis.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

namespace desmo {

DenseGroup::DenseGroup(const Model& m, const PartDefinition& group, const Magnitudes& magnitudes)
    : equations_(m, group), weights_(equations_.pattern().n) {
  for (int r = 0; r < weights_.size(); ++r) weights_[r] = 1 / magnitudes.of(group.equations[r]);
}

Eigen::VectorXd DenseGroup::residual(const std::vector<double>& state) const {
  Eigen::VectorXd phi(equations_.pattern().n);
  equations_.residual(state.data(), phi.data());
  return phi;
}

Eigen::MatrixXd DenseGroup::jacobian(const std::vector<double>& state) const {
  const Pattern& p = equations_.pattern();
  std::vector<double> values(p.size());
  equations_.constant_jacobian(values.data());
  equations_.jacobian(state.data(), values.data());
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(p.n, p.n);
  for (int j = 0; j < p.n; ++j)
    for (int k = p.column_start[j]; k < p.column_start[j + 1]; ++k) dense(p.row[k], j) = values[k];
  return dense;
}

int DenseGroup::solve(std::vector<double>& state, const Settings& settings) const {
  for (int iteration = 0;; ++iteration) {
    const Eigen::VectorXd phi = residual(state);
    if (!phi.allFinite()) return worst_row(phi);
    const Eigen::VectorXd weighted = weights_.cwiseProduct(phi);
    const bool solved = weighted.norm() < settings.tolerance;
    if (!solved && iteration == settings.max_iterations) return worst_row(weighted);
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(jacobian(state));
    if (!lu.isInvertible())  // the rows that depend on each other are in the left null space
      return worst_row(
          Eigen::FullPivLU<Eigen::MatrixXd>(jacobian(state).transpose()).kernel().col(0));
    if (solved) return -1;
    const Eigen::VectorXd step = lu.solve(phi);
    for (int i = 0; i < step.size(); ++i) state[unknowns()[i]] -= step[i];
  }
}

int worst_row(const Eigen::VectorXd& v) {
  int worst = 0;
  for (int i = 0; i < v.size(); ++i) {
    if (std::isnan(v[i])) return i;
    if (std::abs(v[i]) > std::abs(v[worst])) worst = i;
  }
  return worst;
}

Culprit find_culprit(const Model& m, std::span<const GroupId> groups, std::vector<double> state,
                     const Settings& settings) {
  const Magnitudes magnitudes(m);
  for (const PartDefinition& group : make_partition(m, Partition::group)) {
    const GroupId g = group.groups.front();
    if (std::ranges::find(groups, g) == groups.end()) continue;
    const int row = DenseGroup(m, group, magnitudes).solve(state, settings);
    if (row >= 0) return {g, group.equations[row].constraint};
  }
  return {};
}

}  // namespace desmo
