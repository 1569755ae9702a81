#include "formulations/diagnosis.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "formulations/equations/automatic.h"
#include "formulations/magnitudes.h"
#include "formulations/partition.h"

namespace desmo {

namespace {

/// The row of the largest component, or of the first that is not a number.
int worst_row(const Eigen::VectorXd& v) {
  int worst = 0;
  for (int i = 0; i < v.size(); ++i) {
    if (std::isnan(v[i])) return i;
    if (std::abs(v[i]) > std::abs(v[worst])) worst = i;
  }
  return worst;
}

Eigen::MatrixXd dense_jacobian(const AutomaticEquations& equations, const double* state) {
  const Pattern& p = equations.pattern();
  std::vector<double> values(p.size());
  equations.constant_jacobian(values.data());
  equations.jacobian(state, values.data());
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(p.n, p.n);
  for (int j = 0; j < p.n; ++j)
    for (int k = p.column_start[j]; k < p.column_start[j + 1]; ++k) dense(p.row[k], j) = values[k];
  return dense;
}

/// Solves the positions of one group in `state`; the row that stopped it, or -1.
int solve_group(const AutomaticEquations& equations, const Eigen::VectorXd& weights,
                std::vector<double>& state, const Settings& settings) {
  Eigen::VectorXd phi(equations.pattern().n);
  for (int iteration = 0;; ++iteration) {
    equations.residual(state.data(), phi.data());
    if (!phi.allFinite()) return worst_row(phi);
    const Eigen::VectorXd weighted = weights.cwiseProduct(phi);
    const bool solved = weighted.norm() < settings.tolerance;
    if (!solved && iteration == settings.max_iterations) return worst_row(weighted);
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(dense_jacobian(equations, state.data()));
    if (!lu.isInvertible())  // the rows that depend on each other are in the left null space
      return worst_row(
          Eigen::FullPivLU<Eigen::MatrixXd>(dense_jacobian(equations, state.data()).transpose())
              .kernel()
              .col(0));
    if (solved) return -1;
    const Eigen::VectorXd step = lu.solve(phi);
    for (int i = 0; i < step.size(); ++i) state[equations.pattern().unknowns[i]] -= step[i];
  }
}

}  // namespace

Culprit find_culprit(const Mechanism& m, std::span<const GroupId> groups, std::vector<double> state,
                     const Settings& settings) {
  const Magnitudes magnitudes(m);
  for (const PartDefinition& group : make_partition(m, Partition::group)) {
    const GroupId g = group.groups.front();
    if (std::ranges::find(groups, g) == groups.end()) continue;
    const std::vector<double> weights = magnitudes.weights(group);
    const int row = solve_group(AutomaticEquations(m, group),
                                Eigen::Map<const Eigen::VectorXd>(weights.data(), weights.size()),
                                state, settings);
    if (row >= 0) return {g, group.equations[row].constraint};
  }
  return {};
}

}  // namespace desmo
