#pragma once

#include <array>
#include <span>
#include <vector>

#include "formulations/constraints/jet.h"
#include "formulations/constraints/kind_functions.h"
#include "formulations/model/constraint_at.h"
#include "formulations/model/model.h"

namespace desmo {

/// Returns the constants that the functions of a constraint's kind take for jets x: those at the
/// values of x, as jets that are constant in time.
template <class S>
std::array<Jet<S>, max_constants> dimensions_at(const Constraint& constraint,
                                                const Jet<S>* const* x) {
  const KindDescription& kind = description_of(constraint.kind);
  std::array<std::array<S, max_components>, max_operands> values;
  std::array<const S*, max_operands> at{};
  for (std::size_t k = 0; k < kind.operand_sizes.size(); ++k) {
    for (int i = 0; i < kind.operand_sizes[k]; ++i) values[k][i] = x[k][i].value;
    at[k] = values[k].data();
  }
  const std::array<S, max_constants> still = dimensions_at(constraint, at.data());
  std::array<Jet<S>, max_constants> all{};
  for (int k = 0; k < kind.constants; ++k) all[k] = Jet<S>(still[k]);
  return all;
}

/// The equations of a whole model at once, whatever the partition. Rows are the kept rows of the
/// constraints, in their order. Columns are the coordinates that are not driven, ascending.
class WholeSystem {
 public:
  /// The model must outlive this object.
  explicit WholeSystem(const Model& m) : m_(m), column_(m.state_size(), -1) {
    const std::vector<bool> driven = independent_coordinates(m);
    for (int i = 0; i < m.coordinates(); ++i)
      if (!driven[i]) {
        column_[i] = static_cast<int>(unknowns_.size());
        unknowns_.push_back(i);
      }
    for (const Constraint& c : m.constraints) rows_ += kept_rows(c);
  }

  int rows() const { return rows_; }
  const std::vector<int>& unknowns() const { return unknowns_; }  ///< (columns)
  int column(int state) const { return column_[state]; }          ///< of a state; -1: no unknown

  /// Evaluates Φ at a state in any scalar. Overwrites phi (rows()).
  template <class S>
  void residual(std::span<const S> state, std::span<S> phi) const {
    int row = 0;
    for (const Constraint& constraint : m_.constraints) {
      const ConstraintAt<S> at(m_, constraint, state.data());
      std::array<S, max_rows> all;
      at.residual(all.data());
      for (int r = 0; r < at.kind.rows; ++r)
        if (!(constraint.left_out >> r & 1)) phi[row++] = all[r];
    }
  }

  /// Calls entry(row, component, ∂Φ_row/∂component) for each entry, always in the same order.
  /// Components are those of the state; driven and fixed entities are included.
  template <class S, class Entry>
  void jacobian(std::span<const S> state, Entry&& entry) const {
    int row = 0;
    for (const Constraint& constraint : m_.constraints) {
      const ConstraintAt<S> at(m_, constraint, state.data());
      std::array<int, max_rows> place;
      for (int r = 0; r < at.kind.rows; ++r) place[r] = constraint.left_out >> r & 1 ? -1 : row++;
      at.jacobian([&](int r, int operand, int i, const S& value) {
        if (place[r] >= 0) entry(place[r], m_.state_index(constraint.operands[operand]) + i, value);
      });
    }
  }

 private:
  const Model& m_;
  std::vector<int> unknowns_, column_;
  int rows_ = 0;
};

}  // namespace desmo
