#include "formulations/modelling/independence/independence.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "formulations/modelling/independence/refusal.h"
#include "formulations/modelling/independence/row_selection.h"
#include "formulations/scaling/characteristic_lengths.h"
#include "formulations/scaling/scales.h"

namespace desmo {

namespace {

using Eigen::MatrixXd;
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
    const Linearisation now = lineariser.at(state, s);
    const VectorXd off = now.relative_phi();
    if (iteration == most || !off.allFinite() || !(off.lpNorm<Eigen::Infinity>() > agrees / 100))
      return off;
    VectorXd step = VectorXd::Zero(static_cast<Eigen::Index>(s.columns.size()));
    step.head(s.unknowns) = -smallest_correction(now.jacobian.leftCols(s.unknowns), now.phi);
    if (!(step.norm() > 1e-14)) return off;
    lineariser.move(state, s, step);
  }
}

/// The length that an equation's points are judged by, or 1.
double unit_of(const Model& m, const Constraint& c) {
  for (const EntityId e : c.operands)
    if (is_length(m.entities[e].kind)) return CharacteristicLengths(m).of(c);
  return 1;
}

/// Moves a group's drivers a little from an assembled position, first forwards, then backwards.
/// Returns nullopt when all its candidates, dependent ones included, can follow in one direction.
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

/// The constraints of which a row is a combination.
std::vector<std::string> sources(const Model& m, const GroupSystem& s, const SelectedRows& selected,
                                 int row) {
  const MatrixXd& j = selected.jacobians[1];
  std::vector<int> taken;
  for (std::size_t i = 0; i < selected.taken.size(); ++i)
    if (selected.taken[i]) taken.push_back(static_cast<int>(i));
  MatrixXd basis(s.unknowns, static_cast<int>(taken.size()));
  for (std::size_t k = 0; k < taken.size(); ++k)
    basis.col(k) = j.row(taken[k]).head(s.unknowns).transpose();
  std::vector<std::string> names;
  if (basis.size() == 0) return names;
  const VectorXd weights =
      basis.colPivHouseholderQr().solve(j.row(row).head(s.unknowns).transpose());
  for (std::size_t k = 0; k < taken.size(); ++k) {
    const std::string& name = m.constraints[s.rows[taken[k]].first].name;
    if (std::abs(weights[k]) > dependent_below && (names.empty() || names.back() != name))
      names.push_back(name);
  }
  return names;
}

/// Marks what was not selected in the mechanism.
void mark_left_out(Model& m, const GroupSystem& s, const SelectedRows& selected, bool redundant,
                   std::vector<LeftOut>& left_out) {
  for (std::size_t i = 0; i < selected.taken.size(); ++i) {
    if (selected.taken[i]) continue;
    const auto [c, row] = s.rows[i];
    m.constraints[c].left_out |= 1u << row;
    const bool another_row = !left_out.empty() && left_out.back().group == s.group &&
                             left_out.back().equation == m.constraints[c].name;
    if (!another_row) left_out.push_back({m.constraints[c].name, {}, s.group, {}, redundant});
    left_out.back().rows.push_back(row);
    for (const std::string& name : sources(m, s, selected, static_cast<int>(i)))
      if (std::ranges::find(left_out.back().follows_from, name) ==
          left_out.back().follows_from.end())
        left_out.back().follows_from.push_back(name);
  }
}

}  // namespace

std::vector<LeftOut> leave_out_dependent(Candidates& candidates, const std::vector<int>& surplus) {
  Model& m = candidates.model;
  std::vector<GroupSystem> systems = group_systems(m);
  Linearisers linearisers(m);
  const JudgedPositions positions = assemble_positions(m, systems, linearisers);
  RowSelector selector(candidates, positions, linearisers);
  std::vector<LeftOut> left_out;
  for (GroupSystem& s : systems) {
    SelectedRows selected = selector.select(s);
    std::optional<Contradiction> contradiction;
    if (surplus[s.group] > 0 && s.drivers() > 0)
      contradiction = find_contradiction(m, s, positions[1], linearisers.usual);
    // Of whole definitions: parts of them contradict nothing.
    require_determined(m, s, selected, contradiction);
    selector.shorten(s, selected);
    mark_left_out(m, s, selected, surplus[s.group] > 0, left_out);
  }
  return left_out;
}

}  // namespace desmo
