#include "formulations/modelling/independence/sampled_positions.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <utility>

#include "formulations/modelling/independence/refusal.h"

namespace desmo {

namespace {

using Eigen::VectorXd;

/// Assembles a group from an estimate, even where equations depend on each other: by the
/// Gauss–Newton method with the smallest correction, over unknowns and drivers. Returns whether Φ
/// vanishes, except for rounding, or is < max_misfit in a group that closes_nearly().
bool assemble(std::vector<double>& state, const GroupSystem& s, Lineariser& lineariser) {
  constexpr int max_iterations = 100;
  constexpr double max_residual = 1e-9;  // relative |Φ| < this: Φ vanishes
  const double closes = s.closes_nearly() ? max_misfit : max_residual;
  double largest = INFINITY;
  for (int iteration = 0; iteration < max_iterations; ++iteration) {
    const Linearisation now = lineariser.at(state, s);
    if (!now.phi.allFinite() || !now.jacobian.allFinite()) return false;
    if (now.phi.size() == 0) return true;
    const double before = std::exchange(largest, now.relative_phi().lpNorm<Eigen::Infinity>());
    if (largest < 1e-13 || (largest < max_residual && !(largest < before / 2))) return true;
    const VectorXd step = smallest_correction(s, now.jacobian, now.phi);
    lineariser.move(state, s, -step);
    if (!(step.norm() > 1e-14)) break;
  }
  return largest < closes;
}

/// Assembles a group, scaled by the longest lengths of its bodies. Where that fails, or small
/// bodies on large ones do not close, scales it by the shortest ones.
bool assemble(std::vector<double>& state, const GroupSystem& s, Linearisers& linearisers) {
  constexpr double max_small_residual = 1e-7;  // relative |Φ| ≤ this changes no rank
  const std::vector<double> estimate = state;
  if (!assemble(state, s, linearisers.usual))
    state = estimate;
  else if (s.rows.empty() ||
           linearisers.of_small.at(state, s).relative_phi().maxCoeff() <= max_small_residual)
    return true;
  return assemble(state, s, linearisers.of_small);
}

/// Assembles a group. Where that fails for a redundant group, assembles it to the digits of its
/// file and makes it one that closes_nearly().
bool assemble_nearly(std::vector<double>& state, GroupSystem& s, Linearisers& linearisers) {
  const std::vector<double> estimate = state;
  if (assemble(state, s, linearisers)) return true;
  if (!s.redundant || s.closes_nearly()) return false;
  GroupSystem nearly = s;
  nearly.dependent_below = max_misfit;
  state = estimate;
  if (!assemble(state, nearly, linearisers)) return false;
  s = nearly;
  return true;
}

/// Moves every group along its freedoms and assembles it anew. Returns nullopt when one cannot be.
/// - amount: largest movement of a coordinate, before projection [natural magnitudes]
/// - nearly: redundant groups may close only to the digits of their file
std::optional<std::vector<double>> perturb(std::vector<double> state, double amount, int seed,
                                           std::vector<GroupSystem>& systems,
                                           Linearisers& linearisers, bool nearly) {
  Lineariser& lineariser = linearisers.usual;
  std::mt19937 random(seed);
  for (GroupSystem& s : systems) {
    const Eigen::MatrixXd jacobian = lineariser.at(state, s).jacobian;
    VectorXd step(s.columns.size());
    for (double& x : step) x = amount * (random() / 2147483648.0 - 1);
    if (jacobian.size() > 0) step -= smallest_correction(s, jacobian, jacobian * step);
    lineariser.move(state, s, step);
    if (!(nearly ? assemble_nearly(state, s, linearisers) : assemble(state, s, linearisers)))
      return std::nullopt;
  }
  return state;
}

SampledPositions assembled(const Model& m, std::vector<GroupSystem>& systems,
                           Linearisers& linearisers) {
  SampledPositions positions;
  std::vector<double>& nominal = positions[0];
  nominal = m.state_of(m.estimate);
  for (GroupSystem& s : systems) {
    if (!assemble_nearly(nominal, s, linearisers))
      refuse_assembly(m, s, linearisers.of_small.at(nominal, s).relative_phi());
  }
  const auto perturbed = [&](int seed) -> std::optional<std::vector<double>> {
    for (const bool nearly : {false, true})
      for (double amount = 0.02; amount > 0.002; amount /= 2)
        if (auto state = perturb(nominal, amount, seed, systems, linearisers, nearly)) return state;
    return {};
  };
  for (std::size_t p = 1; p < positions.size(); ++p)
    positions[p] = perturbed(static_cast<int>(p)).value_or(nominal);
  return positions;
}

}  // namespace

SampledPositions assemble_positions(const Model& m, std::vector<GroupSystem>& systems,
                                    Linearisers& linearisers) {
  const SampledPositions positions = assembled(m, systems, linearisers);
  bool again = false;
  for (GroupSystem& s : systems) {
    if (!s.redundant || s.closes_nearly() || s.drivers() == 0) continue;
    const SampledJacobians jacobians = sample_jacobians(s, positions, linearisers);
    GroupSystem nearly = s;
    nearly.dependent_below = max_misfit;
    if (mobility(s, jacobians) >= s.drivers() || mobility(nearly, jacobians) < s.drivers())
      continue;
    s = nearly;
    again = true;
  }
  return again ? assembled(m, systems, linearisers) : positions;
}

SampledJacobians sample_jacobians(const GroupSystem& s, const SampledPositions& positions,
                                  Linearisers& linearisers) {
  SampledJacobians jacobians;
  for (std::size_t p = 0; p < positions.size(); ++p)
    jacobians[p] = linearisers.usual.at(positions[p], s).jacobian;
  return jacobians;
}

int mobility(const GroupSystem& s, const SampledJacobians& jacobians) {
  const int columns = static_cast<int>(s.columns.size());
  int rank = 0;
  for (const Eigen::MatrixXd& jacobian : jacobians) {
    RowSpace space(s, columns);
    for (int i = 0; i < jacobian.rows(); ++i) space.add(jacobian.row(i).transpose());
    rank = std::max(rank, space.rank());
  }
  return columns - rank;
}

}  // namespace desmo
