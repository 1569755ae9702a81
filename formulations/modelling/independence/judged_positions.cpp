#include <cmath>
#include <optional>
#include <random>
#include <utility>

#include "formulations/modelling/independence/refusal.h"
#include "formulations/modelling/independence/row_selection.h"

namespace desmo {

namespace {

using Eigen::VectorXd;

/// Gauss–Newton with the smallest correction, over unknowns and drivers: assembles from an
/// estimate even where equations depend on each other. Returns whether Φ vanishes, as far as
/// rounding lets it, which is the less the farther from the origin a group is.
bool assemble(std::vector<double>& state, const GroupSystem& s, Lineariser& lineariser) {
  constexpr int most = 100;
  constexpr double vanishes = 1e-9;
  double largest = INFINITY;
  for (int iteration = 0; iteration < most; ++iteration) {
    const auto [phi, jacobian] = lineariser.at(state, s);
    if (!phi.allFinite() || !jacobian.allFinite()) return false;
    if (phi.size() == 0) return true;
    const double before = std::exchange(largest, phi.lpNorm<Eigen::Infinity>());
    if (largest < 1e-13 || (largest < vanishes && !(largest < before / 2))) return true;
    const VectorXd step = smallest_correction(jacobian, phi);
    lineariser.move(state, s, -step);
    if (!(step.norm() > 1e-14)) break;
  }
  return largest < vanishes;
}

/// Moves every group a little along its freedoms and assembles it anew.
std::optional<std::vector<double>> perturb(std::vector<double> state, double amount, int seed,
                                           const std::vector<GroupSystem>& systems,
                                           Lineariser& lineariser) {
  std::mt19937 random(seed);
  for (const GroupSystem& s : systems) {
    const Eigen::MatrixXd jacobian = lineariser.at(state, s).jacobian;
    VectorXd step(s.columns.size());
    for (double& x : step) x = amount * (random() / 2147483648.0 - 1);
    if (jacobian.size() > 0) step -= smallest_correction(jacobian, jacobian * step);
    lineariser.move(state, s, step);
    if (!assemble(state, s, lineariser)) return std::nullopt;
  }
  return state;
}

}  // namespace

JudgedPositions assemble_positions(const Model& m, const std::vector<GroupSystem>& systems,
                                   Lineariser& lineariser) {
  JudgedPositions positions;
  std::vector<double>& nominal = positions[0];
  nominal = m.estimate;
  nominal.insert(nominal.end(), m.fixed_values.begin(), m.fixed_values.end());
  for (const GroupSystem& s : systems)
    if (!assemble(nominal, s, lineariser)) refuse_assembly(m, s, lineariser.at(nominal, s).phi);
  for (std::size_t p = 1; p < positions.size(); ++p) {
    positions[p] = nominal;
    for (double amount = 0.02; amount > 0.002; amount /= 2)
      if (auto state = perturb(nominal, amount, static_cast<int>(p), systems, lineariser)) {
        positions[p] = std::move(*state);
        break;
      }
  }
  return positions;
}

}  // namespace desmo
