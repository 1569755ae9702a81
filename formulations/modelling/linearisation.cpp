#include "formulations/modelling/linearisation.h"

#include <array>
#include <cmath>
#include <utility>

namespace desmo {

Lineariser::Lineariser(const Mechanism& mechanism, double size)
    : m_(mechanism), scale_(mechanism.state_size(), 1.0), column_(mechanism.state_size(), -1) {
  for (EntityId e = 0; e < static_cast<EntityId>(m_.entities.size()); ++e) {
    const EntityKind kind = m_.entities[e].kind;
    if (kind != EntityKind::point && kind != EntityKind::distance) continue;
    for (int i = m_.state_index(e); i < m_.state_index(e) + m_.entities[e].size; ++i)
      scale_[i] = size;
  }
}

Linearisation Lineariser::at(const std::vector<double>& state, const GroupSystem& s) {
  const int n = static_cast<int>(s.rows.size());
  Eigen::VectorXd phi(n), length2 = Eigen::VectorXd::Zero(n);
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(n, static_cast<int>(s.columns.size()));
  for (std::size_t j = 0; j < s.columns.size(); ++j) column_[s.columns[j]] = static_cast<int>(j);
  int row = 0;
  for (int c = s.first_constraint; c < s.end_constraint; ++c) {
    const Constraint& constraint = m_.constraints[c];
    visit_kind(constraint.kind, [&]<class Kind>(Kind) {
      std::array<const double*, Kind::operand_sizes.size()> x;
      std::array<int, Kind::operand_sizes.size()> first;
      for (std::size_t k = 0; k < x.size(); ++k) {
        first[k] = m_.state_index(constraint.operands[k]);
        x[k] = state.data() + first[k];
      }
      Kind::residual(x.data(), constraint.constants.data(), &phi[row]);
      Kind::jacobian(x.data(), constraint.constants.data(),
                     [&](int r, int operand, int i, double value) {
                       const int at = first[operand] + i;
                       const double scaled = value * scale_[at];
                       length2[row + r] += scaled * scaled;
                       if (column_[at] >= 0) jacobian(row + r, column_[at]) += scaled;
                     });
      row += Kind::rows;
    });
  }
  for (const int i : s.columns) column_[i] = -1;
  for (int i = 0; i < n; ++i) {
    const double length = std::sqrt(length2[i]);
    if (length == 0) continue;
    phi[i] /= length;
    jacobian.row(i) /= length;
  }
  return {std::move(phi), std::move(jacobian)};
}

void Lineariser::move(std::vector<double>& state, const GroupSystem& s,
                      const Eigen::VectorXd& step) const {
  for (std::size_t j = 0; j < s.columns.size(); ++j)
    state[s.columns[j]] += scale_[s.columns[j]] * step[j];
}

}  // namespace desmo
