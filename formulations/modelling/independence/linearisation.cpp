#include "formulations/modelling/independence/linearisation.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <utility>

#include "formulations/model/characteristic_lengths.h"
#include "formulations/model/constraint_at.h"
#include "formulations/model/scales.h"

namespace desmo {

namespace {

/// Smallest certain norm of a row's entries in the columns of its group, relative to that of its
/// derivatives by all other variables. Below it, uncertainty of those variables may explain them.
constexpr double certain = 1e-8;
/// Shortest length of a point that counts, relative to its longest one; below it, this much counts.
constexpr double min_share = 1e-10;
/// Rounding of each variable that an equation reads, relative to the variable.
constexpr double ulps = 0x1p-52;

std::vector<GroupSystem> list_columns(const Model& m) {
  const std::vector<bool> independent = independent_coordinates(m);
  std::vector<GroupSystem> systems(m.groups.size());
  for (GroupId g = 0; g < static_cast<GroupId>(systems.size()); ++g) systems[g].group = g;
  std::vector<std::vector<int>> drivers(m.groups.size());
  for (const Entity& e : m.entities)
    for (int i = e.first; !e.fixed && i < e.first + e.size; ++i)
      (independent[i] ? drivers[e.group] : systems[e.group].columns).push_back(i);
  for (GroupSystem& s : systems) {
    s.unknowns = static_cast<int>(s.columns.size());
    s.columns.insert(s.columns.end(), drivers[s.group].begin(), drivers[s.group].end());
  }
  return systems;
}

}  // namespace

std::vector<GroupSystem> group_systems(const Model& m) {
  std::vector<GroupSystem> systems = list_columns(m);
  const int constraints = static_cast<int>(m.constraints.size());
  int c = 0;
  for (GroupSystem& s : systems) {
    s.first_constraint = s.end_constraint = c;
    for (; c < constraints && m.constraints[c].group == s.group; ++c)
      if (!is_constant(m, m.constraints[c])) s.end_constraint = c + 1;
    list_rows(m, s);
  }
  return systems;
}

void list_rows(const Model& m, GroupSystem& s) {
  s.rows.clear();
  for (int c = s.first_constraint; c < s.end_constraint; ++c)
    for (int r = 0; r < rows(m.constraints[c]); ++r) s.rows.emplace_back(c, r);
}

Lineariser::Lineariser(const Model& model, Lengths which)
    : m_(model), scale_(model.state_size(), 1.0), column_(model.state_size(), -1) {
  const CharacteristicLengths lengths(m_);
  for (EntityId e = 0; e < static_cast<EntityId>(m_.entities.size()); ++e) {
    if (!is_length(m_.entities[e].kind)) continue;
    double length = lengths.of(e);
    if (which == Lengths::shortest) length = std::max(lengths.shortest(e), min_share * length);
    std::fill_n(scale_.begin() + m_.state_index(e), m_.entities[e].size,
                std::ldexp(1, std::ilogb(length)));
  }
}

Linearisation Lineariser::at(const std::vector<double>& state, const GroupSystem& s) {
  const int n = static_cast<int>(s.rows.size());
  // length: norm of each row's derivatives by the variables that are no columns of the group.
  Eigen::VectorXd phi(n), length = Eigen::VectorXd::Zero(n);
  Eigen::VectorXd share = Eigen::VectorXd::Ones(n), rounding = Eigen::VectorXd::Zero(n);
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(n, static_cast<int>(s.columns.size()));
  for (std::size_t j = 0; j < s.columns.size(); ++j) column_[s.columns[j]] = static_cast<int>(j);
  int row = 0;
  for (int c = s.first_constraint; c < s.end_constraint; ++c) {
    const Constraint& constraint = m_.constraints[c];
    const ConstraintAt<double> at(m_, constraint, state.data());
    at.residual(&phi[row]);
    at.jacobian([&](int r, int operand, int i, double value) {
      const int variable = m_.state_index(constraint.operands[operand]) + i;
      const double scaled = value * scale_[variable];
      rounding[row + r] += ulps * std::abs(value * state[variable]);
      if (column_[variable] >= 0)
        jacobian(row + r, column_[variable]) += scaled;
      else
        length[row + r] = std::hypot(length[row + r], scaled);
    });
    row += at.kind.rows;
  }
  for (const int i : s.columns) column_[i] = -1;
  for (int i = 0; i < n; ++i) {
    const double own = jacobian.row(i).stableNorm(), scale = std::max(own, certain * length[i]);
    if (scale == 0) continue;
    share[i] = scale / std::hypot(own, length[i]);
    phi[i] /= scale;
    rounding[i] /= scale;
    jacobian.row(i) /= scale;
  }
  return {std::move(phi), std::move(jacobian), std::move(share), std::move(rounding)};
}

void Lineariser::move(std::vector<double>& state, const GroupSystem& s,
                      const Eigen::VectorXd& step) const {
  for (std::size_t j = 0; j < s.columns.size(); ++j)
    state[s.columns[j]] += scale_[s.columns[j]] * step[j];
}

bool RowSpace::add(Eigen::VectorXd row, double uncertain) {
  if (rank_ == basis_.cols()) return false;
  for (int pass = 0; pass < 2; ++pass)  // the second pass removes what rounding left in the first
    row -= basis_.leftCols(rank_) * (basis_.leftCols(rank_).transpose() * row);
  const double remaining = row.norm();
  if (!(remaining > std::max(dependent_below_, uncertainty_margin * uncertain))) return false;
  basis_.col(rank_++) = row / remaining;
  return true;
}

Eigen::MatrixXd smallest_correction(const GroupSystem& s, const Eigen::MatrixXd& jacobian,
                                    const Eigen::MatrixXd& phi) {
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  decomposition.setThreshold(s.dependent_below);
  return decomposition.compute(jacobian).solve(phi);
}

}  // namespace desmo
