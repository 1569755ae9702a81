#include "formulations/modelling/independence/row_selection.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <type_traits>
#include <utility>

#include "formulations/constraints/constraints.h"
#include "formulations/model/characteristic_lengths.h"
#include "formulations/model/model.h"
#include "formulations/model/scales.h"

namespace desmo {

namespace {

using Eigen::VectorXd;

/// Returns by how much rounding of positions may change the derivatives of each row, relative to
/// them: rounding divided by the smallest characteristic length. It is 0 for linear equations.
VectorXd uncertainty(const Model& m, const std::vector<double>& state, const GroupSystem& s) {
  constexpr double unit = 0x1p-52;
  const CharacteristicLengths lengths(m);
  VectorXd result = VectorXd::Zero(static_cast<Eigen::Index>(s.rows.size()));
  for (std::size_t r = 0; r < s.rows.size(); ++r) {
    const Constraint& c = m.constraints[s.rows[r].first];
    if (is_linear(c)) continue;
    double shortest = INFINITY, farthest = 0;
    for (const EntityId e : c.operands) {
      if (!is_length(m.entities[e].kind)) continue;
      shortest = std::min(shortest, lengths.of(e));
      for (int i = 0; i < m.entities[e].size; ++i)
        farthest = std::max(farthest, std::abs(state[m.state_index(e) + i]));
    }
    result[static_cast<Eigen::Index>(r)] = unit * farthest / shortest;
  }
  return result;
}

/// Replaces a definition of several equations by the single one that says the same. Returns whether
/// the constraint is such a definition.
bool make_scalar(Constraint& constraint) {
  bool shorter = false;
  visit_kind(constraint.kind, [&]<class Kind>(Kind) {
    using Scalar = ScalarDefinition<Kind>;
    if constexpr (!std::is_void_v<Scalar>) {
      constraint.kind = kind_index<Scalar>();
      constraint.constants.resize(Scalar::constants);
      shorter = true;
    }
  });
  return shorter;
}

}  // namespace

void RowSelector::shorten(GroupSystem& s, SelectedRows& selected) {
  for (;;) {
    const auto first = m_.constraints.begin() + s.first_constraint,
               end = m_.constraints.begin() + s.end_constraint;
    const std::vector<Constraint> before(first, end);
    if (!shorten_definitions(s, selected.taken)) return;
    list_rows(m_, s);
    SelectedRows shortened = select(s);
    if (std::ranges::count(shortened.taken, true) < std::ranges::count(selected.taken, true)) {
      std::ranges::copy(before, first);
      list_rows(m_, s);
      return;
    }
    selected = std::move(shortened);
  }
}

/// Selects rows at the position of highest rank, since positions of lower rank are special ones.
/// Among equals, perturbed positions come first.
SelectedRows RowSelector::select(const GroupSystem& s) {
  SelectedRows selected;
  selected.jacobians = sample_jacobians(s, positions_, linearisers_);
  const std::vector<int> order = preference(s);
  int best_rank = -1;
  // uncertain: of each row; empty: 0
  const auto take = [&](const Eigen::MatrixXd& jacobian, const std::vector<bool>& among,
                        const VectorXd& uncertain = {}) {
    std::vector<bool> taken(s.rows.size(), false);
    RowSpace space(s, s.unknowns);
    for (const int i : order)
      if (among[i])
        taken[i] = space.add(jacobian.row(i).head(s.unknowns).transpose(),
                             uncertain.size() > 0 ? uncertain[i] : 0);
    return std::pair(space.rank(), std::move(taken));
  };
  const SampledJacobians& at = selected.jacobians;
  const std::vector<bool> all(s.rows.size(), true);
  for (const int p : {1, 2, 0}) {
    auto [rank, taken] = take(at[p], all);
    if (rank <= best_rank) continue;
    best_rank = rank;
    selected.taken = std::move(taken);
    if (best_rank == s.unknowns) break;
  }
  // Scaled by the lengths of a large body, a small one on it may look free.
  if (best_rank < s.unknowns) {
    const Linearisation small = linearisers_.of_small.at(positions_[0], s);
    const VectorXd uncertain = uncertainty(m_, positions_[0], s);
    if (auto [rank, taken] = take(small.jacobian, all, uncertain); rank == s.unknowns)
      selected.taken = std::move(taken);
    else if (uncertain.size() > 0)
      selected.uncertain = uncertain.maxCoeff();
  }
  if (std::ranges::find(selected.taken, false) == selected.taken.end()) return selected;
  // Prefers rows that have full rank in the nominal position, too: a motion may rest there.
  if (auto [rank, taken] = take(at[0], all); rank == s.unknowns &&
                                             take(at[0], selected.taken).first < rank &&
                                             take(at[1], taken).first == rank)
    selected.taken = std::move(taken);
  return selected;
}

/// Returns the rows of a system in the order in which select() tries them.
std::vector<int> RowSelector::preference(const GroupSystem& s) const {
  using Rank = std::tuple<bool, bool, int, EquationSource, int>;
  std::vector<Rank> ranks;
  for (int c = s.first_constraint; c < s.end_constraint; ++c) {
    const Constraint& constraint = m_.constraints[c];
    std::vector<int> entries(rows(constraint), 0);
    for (const EntryPlace& e : description_of(constraint.kind).entries)
      entries[e.row] += !m_.is_at_rest(constraint.operands[e.operand]);
    for (const int n : entries)
      ranks.emplace_back(constraint.derives < 0, !is_linear(constraint), n, constraint.source,
                         static_cast<int>(ranks.size()));
  }
  std::ranges::sort(ranks);
  std::vector<int> order;
  for (const Rank& r : ranks) order.push_back(std::get<4>(r));
  return order;
}

/// Shortens definitions of which one row is taken. Returns whether there was any.
bool RowSelector::shorten_definitions(const GroupSystem& s, const std::vector<bool>& taken) {
  std::vector<int> rows_taken(s.end_constraint - s.first_constraint, 0);
  for (std::size_t i = 0; i < taken.size(); ++i)
    rows_taken[s.rows[i].first - s.first_constraint] += taken[i];
  bool any = false;
  for (int c = s.first_constraint; c < s.end_constraint; ++c)
    if (rows_taken[c - s.first_constraint] == 1) any = make_scalar(m_.constraints[c]) || any;
  return any;
}

}  // namespace desmo
