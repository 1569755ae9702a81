#include "formulations/verification/branch/chosen_equations.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <vector>

#include "formulations/modelling/independence/linearisation.h"

namespace desmo {

namespace {

using Eigen::MatrixXd;

/// Other equations are taken if their smallest pivot is more than this times that of the kept ones.
constexpr double better = 1.5;

/// Rows of a group in the order of their pivots, and the pivot of the last row that is needed.
struct RankedRows {
  Eigen::VectorXi order;
  double last;
};

RankedRows ranked(const MatrixXd& rows) {
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(rows.transpose());
  const Eigen::Index n = rows.cols();
  return {qr.colsPermutation().indices(), std::abs(qr.matrixQR()(n - 1, n - 1))};
}

/// Replaces the kept equations of a group where others are clearly more independent. Returns
/// whether it replaced them.
bool choose(Model& m, const GroupSystem& s, const MatrixXd& all) {
  MatrixXd kept(s.unknowns, s.unknowns);
  int count = 0;
  for (Eigen::Index i = 0; i < all.rows(); ++i)
    if (const auto& [c, row] = s.rows[i]; !(m.constraints[c].left_out >> row & 1))
      kept.row(count++) = all.row(i);
  const auto [order, last] = ranked(all);
  if (!(last > better * ranked(kept).last)) return false;
  for (const auto& [c, row] : s.rows) m.constraints[c].left_out |= 1u << row;
  for (int i = 0; i < s.unknowns; ++i) {
    const auto& [c, row] = s.rows[order[i]];
    m.constraints[c].left_out &= ~(1u << row);
  }
  return true;
}

}  // namespace

std::unique_ptr<const Model> with_chosen_equations(const Model& model, std::span<const double> q) {
  if (!has_other_equations(model)) return nullptr;
  auto chosen = std::make_unique<Model>(model);
  const std::vector<double> state = model.state_of(q);
  Lineariser lineariser(model);
  bool is_other = false;
  for (const GroupSystem& s : group_systems(model)) {
    const bool has_others = std::ssize(s.rows) > s.unknowns;
    if (s.unknowns == 0 || model.groups[s.group].constant || !has_others) continue;
    const MatrixXd all = lineariser.at(state, s).jacobian.leftCols(s.unknowns);
    if (all.allFinite() && choose(*chosen, s, all)) is_other = true;
  }
  return is_other ? std::move(chosen) : nullptr;
}

bool has_other_equations(const Model& m) {
  return std::ranges::any_of(m.constraints, [&m](const Constraint& c) {
    return c.left_out != 0 && !m.groups[c.group].constant && !is_constant(m, c);
  });
}

}  // namespace desmo
