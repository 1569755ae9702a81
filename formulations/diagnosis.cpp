#include "formulations/diagnosis.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

#include "formulations/equations/automatic.h"
#include "formulations/partition.h"

namespace desmo {

namespace {

int largest(const Eigen::VectorXd& v) {
  Eigen::Index i = 0;
  v.cwiseAbs().maxCoeff(&i);
  return static_cast<int>(i);
}

int first_not_finite(const Eigen::VectorXd& v) {
  for (int i = 0; i < v.size(); ++i)
    if (!std::isfinite(v[i])) return i;
  return -1;
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

}  // namespace

Culprit find_culprit(const Mechanism& m, std::span<const GroupId> groups,
                     std::span<const double> state, Status status, double tolerance) {
  struct Candidate {
    PartDefinition definition;
    AutomaticEquations equations;
    Eigen::VectorXd phi;
  };
  std::vector<Candidate> candidates;
  double total = 0;
  for (PartDefinition& d : make_partition(m, Partition::group)) {
    if (std::ranges::find(groups, d.groups.front()) == groups.end()) continue;
    AutomaticEquations equations(m, d);
    Eigen::VectorXd phi(equations.pattern().n);
    equations.residual(state.data(), phi.data());
    if (const int row = first_not_finite(phi); row >= 0)
      return {d.groups.front(), constraint_of_row(m, d)[row]};
    total += phi.norm();
    candidates.push_back({std::move(d), std::move(equations), std::move(phi)});
  }

  // Beside the huge residuals of an iteration that ran away, groups that are solved keep what
  // rounding leaves in them.
  const double unsatisfied = tolerance + 1e-8 * total;
  Culprit culprit;
  double least_condition = std::numeric_limits<double>::infinity();
  for (const auto& [definition, equations, phi] : candidates) {
    const GroupId g = definition.groups.front();
    const std::vector<int> constraint = constraint_of_row(m, definition);
    if (status != Status::singular) {
      if (phi.norm() >= unsatisfied) return {g, constraint[largest(phi)]};
      continue;
    }
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(dense_jacobian(equations, state.data()),
                                                Eigen::ComputeFullU);
    const double condition = svd.singularValues().minCoeff() / svd.singularValues().maxCoeff();
    if (condition < least_condition) {
      least_condition = condition;
      culprit = {g, constraint[largest(svd.matrixU().rightCols<1>())]};
    }
  }
  return culprit;
}

}  // namespace desmo
