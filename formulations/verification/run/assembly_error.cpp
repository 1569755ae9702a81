#include "formulations/verification/run/assembly_error.h"

#include <Eigen/Core>
#include <algorithm>
#include <unsupported/Eigen/NonLinearOptimization>

#include "formulations/model/magnitudes.h"
#include "formulations/model/partition.h"
#include "formulations/model/scales.h"
#include "formulations/motion/diagnosis.h"

namespace desmo {

namespace {

/// The weighted equations of a group as a function of its unknowns over nominal magnitudes.
struct WeightedEquations {
  using Scalar = double;
  using InputType = Eigen::VectorXd;
  using ValueType = Eigen::VectorXd;
  using JacobianType = Eigen::MatrixXd;

  const DenseGroup& group;
  const std::vector<double>& magnitudes;
  std::vector<double>& state;  // where the function was evaluated last

  int inputs() const { return static_cast<int>(group.unknowns().size()); }
  int values() const { return inputs(); }
  double& unknown(int i) const { return state[group.unknowns()[i]]; }
  double scale(int i) const { return magnitudes[group.unknowns()[i]]; }
  void take(const Eigen::VectorXd& x) const {
    for (int i = 0; i < inputs(); ++i) unknown(i) = x[i] * scale(i);
  }
  int operator()(const Eigen::VectorXd& x, Eigen::VectorXd& phi) const {
    take(x);
    phi = group.weights().cwiseProduct(group.residual(state));
    return 0;
  }
  int df(const Eigen::VectorXd& x, Eigen::MatrixXd& jacobian) const {
    take(x);
    jacobian = group.weights().asDiagonal() * group.jacobian(state);
    for (int i = 0; i < inputs(); ++i) jacobian.col(i) *= scale(i);
    return 0;
  }
};

/// Minimises the weighted equations of a group by Levenberg and Marquardt's method, which also gets
/// through singular positions.
void approach(const DenseGroup& group, const std::vector<double>& magnitudes,
              std::vector<double>& state) {
  WeightedEquations equations{group, magnitudes, state};
  Eigen::VectorXd x(equations.inputs());
  for (int i = 0; i < x.size(); ++i) x[i] = equations.unknown(i) / equations.scale(i);
  Eigen::LevenbergMarquardt<WeightedEquations> method(equations);
  method.parameters.ftol = method.parameters.xtol = Eigen::NumTraits<double>::epsilon();
  method.minimize(x);
  equations.take(x);
}

}  // namespace

std::optional<Misfit> find_assembly_error(const Model& m, std::vector<double> state) {
  const Magnitudes magnitudes(m);
  for (const PartDefinition& definition : make_partition(m, Partition::group)) {
    const DenseGroup group(m, definition, magnitudes);
    std::vector<double> nearest = state;
    if (group.solve(state, Settings{}) < 0) continue;
    approach(group, nominal_magnitudes(m), nearest);
    const Eigen::VectorXd residual = group.residual(nearest),
                          weighted = group.weights().cwiseProduct(residual);
    if (weighted.norm() < default_tolerance) {
      state = nearest;
      continue;
    }
    const int row = worst_row(weighted);
    const Equation& worst = definition.equations[row];
    return misfit_of(m, worst.constraint, worst.row, residual[row], nearest);
  }
  return {};
}

}  // namespace desmo
