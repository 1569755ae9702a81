#include "formulations/verification/run/assembly_error.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "formulations/scaling/magnitudes.h"
#include "formulations/scaling/scales.h"
#include "formulations/stepping/diagnosis.h"
#include "formulations/structure/partition.h"

namespace desmo {

namespace {

/// Comes as near to solving a group as it can: Levenberg and Marquardt's method, which also gets
/// through singular positions. Unknowns are in natural magnitudes.
void approach(const DenseGroup& group, const std::vector<double>& magnitudes,
              std::vector<double>& state) {
  constexpr int max_steps = 200;
  constexpr double max_damping = 1e12, settled = 1e-12;
  const auto weighted = [&](const std::vector<double>& at) -> Eigen::VectorXd {
    return group.weights().cwiseProduct(group.residual(at));
  };
  Eigen::VectorXd scales(group.unknowns().size());
  for (int i = 0; i < scales.size(); ++i) scales[i] = magnitudes[group.unknowns()[i]];
  Eigen::VectorXd phi = weighted(state);
  double damping = 1e-3;
  for (int step = 0; step < max_steps && phi.allFinite() && damping < max_damping; ++step) {
    const Eigen::MatrixXd a =
        group.weights().asDiagonal() * group.jacobian(state) * scales.asDiagonal();
    Eigen::MatrixXd normal = a.transpose() * a;
    normal.diagonal().array() += damping;
    const Eigen::VectorXd change = scales.cwiseProduct(normal.ldlt().solve(a.transpose() * phi));
    std::vector<double> trial = state;
    for (int i = 0; i < change.size(); ++i) trial[group.unknowns()[i]] -= change[i];
    const Eigen::VectorXd next = weighted(trial);
    if (!(next.squaredNorm() < phi.squaredNorm())) {
      damping *= 10;
      continue;
    }
    const bool last = next.squaredNorm() > (1 - settled) * phi.squaredNorm();
    state = trial;
    phi = next;
    damping /= 10;
    if (last) return;
  }
}

/// Whether a group is assembled there, though Newton's method may not have found the position, or
/// not accept it as it is singular.
bool holds(const DenseGroup& group, const std::vector<double>& state, const Settings& settings) {
  constexpr double rounding = 1e-12;  // of residuals over their magnitudes, at most
  return group.weights().cwiseProduct(group.residual(state)).norm() <
         std::max(settings.tolerance, rounding);
}

}  // namespace

std::optional<AssemblyError> find_assembly_error(const Model& m, std::vector<double> state,
                                                 const Settings& settings) {
  const Magnitudes magnitudes(m);
  for (const PartDefinition& definition : make_partition(m, Partition::group)) {
    const DenseGroup group(m, definition, magnitudes);
    std::vector<double> nearest = state;
    if (group.solve(state, settings) < 0) continue;
    approach(group, natural_magnitudes(m), nearest);
    if (holds(group, nearest, settings)) {
      state = nearest;
      continue;
    }
    const int row = worst_row(group.weights().cwiseProduct(group.residual(nearest)));
    const Equation& worst = definition.equations[row];
    const double residual = group.residual(nearest)[row];
    return AssemblyError{misfit_of(m, worst.constraint, worst.row, residual, nearest),
                         m.constraints[worst.constraint].group};
  }
  return {};
}

}  // namespace desmo
