#include "formulations/modelling/independence/contradiction.h"

#include <cmath>

#include "formulations/modelling/independence/row_space.h"
#include "formulations/scaling/characteristic_lengths.h"
#include "formulations/scaling/scales.h"

namespace desmo {

namespace {

using Eigen::VectorXd;

/// Of natural magnitudes: far enough for what contradicts itself by a millionth to show, although
/// other bodies give way to first order.
constexpr double moved = 0.1;
/// Near enough, each, for Newton's method.
constexpr int steps = 10;

/// Rounding, beside that.
constexpr double agrees = 1e-10;

/// Φ where Gauss and Newton's method, over the unknowns alone, ends; the state with it.
VectorXd min_residual(std::vector<double>& state, const GroupSystem& s, Lineariser& lineariser) {
  constexpr int most = 50;
  for (int iteration = 0;; ++iteration) {
    const auto [phi, jacobian] = lineariser.at(state, s);
    if (iteration == most || !phi.allFinite() || !(phi.lpNorm<Eigen::Infinity>() > agrees / 100))
      return phi;
    VectorXd step = VectorXd::Zero(static_cast<Eigen::Index>(s.columns.size()));
    step.head(s.unknowns) = -SmallestCorrection(jacobian.leftCols(s.unknowns))(phi);
    if (!(step.norm() > 1e-14)) return phi;
    lineariser.move(state, s, step);
  }
}

/// The length that an equation's points are judged by, or 1.
double unit_of(const Model& m, const Constraint& c) {
  for (const EntityId e : c.operands)
    if (is_length(m.entities[e].kind)) return CharacteristicLengths(m).of(c);
  return 1;
}

}  // namespace

std::optional<Contradiction> find_contradiction(const Model& m, const GroupSystem& s,
                                                const std::vector<double>& position,
                                                Lineariser& lineariser) {
  if (s.unknowns == 0 || s.rows.empty()) return {};
  Contradiction found{};
  for (const double way : {moved, -moved}) {  // one of them may be out of reach
    VectorXd step = VectorXd::Zero(static_cast<Eigen::Index>(s.columns.size()));
    step.tail(s.drivers()).setConstant(way / steps);
    std::vector<double> state = position;
    VectorXd phi;
    for (int i = 0; i < steps; ++i) {
      lineariser.move(state, s, step);
      phi = min_residual(state, s, lineariser);
    }
    Eigen::Index worst = 0;
    const double off = phi.cwiseAbs().maxCoeff<Eigen::PropagateNaN>(&worst);
    if (off <= agrees) return {};
    const int constraint = s.rows[worst].first;
    found = {constraint, off * unit_of(m, m.constraints[constraint]), way};
  }
  return found;
}

}  // namespace desmo
