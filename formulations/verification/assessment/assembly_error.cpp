#include "formulations/verification/assessment/assembly_error.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "formulations/constraints/constraints.h"
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

/// What it would take to satisfy one equation alone.
AssemblyError shortfall(const Model& m, const Equation& equation,
                        const std::vector<double>& state) {
  const Constraint& c = m.constraints[equation.constraint];
  AssemblyError d{c.group, equation.constraint, 0, false};
  visit_kind(c.kind, [&]<class Kind>(Kind) {
    std::array<const double*, Kind::operand_sizes.size()> x;
    for (std::size_t k = 0; k < x.size(); ++k) x[k] = state.data() + m.state_index(c.operands[k]);
    std::array<double, Kind::rows> phi;
    Kind::residual(x.data(), c.constants.data(), phi.data());
    std::array<double, Kind::operand_sizes.size()> slope{};  // of each operand
    Kind::jacobian(x.data(), c.constants.data(), [&](int row, int operand, int, double value) {
      if (row == equation.row) slope[operand] = std::hypot(slope[operand], value);
    });
    double steepest[2] = {0, 0};  // of what is no length, and of lengths
    for (std::size_t k = 0; k < x.size(); ++k) {
      double& most = steepest[is_length(m.entities[c.operands[k]].kind)];
      most = std::max(most, slope[k]);
    }
    d.is_length = steepest[1] > 0;
    d.amount = std::abs(phi[equation.row]) / steepest[d.is_length];
  });
  return d;
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
    return shortfall(m, definition.equations[row], nearest);
  }
  return {};
}

}  // namespace desmo
