#include "formulations/modelling/independence/row_selection.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <tuple>
#include <type_traits>
#include <utility>

#include "formulations/model/characteristic_lengths.h"
#include "formulations/model/incidence.h"
#include "formulations/model/scales.h"
#include "formulations/modelling/independence/refusal.h"

namespace desmo {

namespace {

using Eigen::VectorXd;

/// Gauss–Newton with the smallest correction, over unknowns and drivers: assembles from an
/// estimate even where equations depend on each other. Returns whether Φ vanishes, as far as
/// rounding lets it, which is the less the farther from the origin a group is.
bool assemble(std::vector<double>& state, const GroupSystem& s, Lineariser& lineariser) {
  constexpr int most = 100;
  constexpr double vanishes = 1e-9;
  const double closes = s.closes_nearly() ? max_misfit : vanishes;
  double largest = INFINITY;
  for (int iteration = 0; iteration < most; ++iteration) {
    const Linearisation now = lineariser.at(state, s);
    if (!now.phi.allFinite() || !now.jacobian.allFinite()) return false;
    if (now.phi.size() == 0) return true;
    const double before = std::exchange(largest, now.relative_phi().lpNorm<Eigen::Infinity>());
    if (largest < 1e-13 || (largest < vanishes && !(largest < before / 2))) return true;
    const VectorXd step = smallest_correction(s, now.jacobian, now.phi);
    lineariser.move(state, s, -step);
    if (!(step.norm() > 1e-14)) break;
  }
  return largest < closes;
}

/// Assembles a group by the longest lengths. Where these lose small bodies on large ones, assembles
/// it by the shortest.
bool assemble(std::vector<double>& state, const GroupSystem& s, Linearisers& linearisers) {
  constexpr double hardly_off = 1e-7;  // which no rank depends on
  const std::vector<double> estimate = state;
  if (!assemble(state, s, linearisers.usual))
    state = estimate;
  else if (s.rows.empty() ||
           linearisers.of_small.at(state, s).relative_phi().maxCoeff() <= hardly_off)
    return true;
  return assemble(state, s, linearisers.of_small);
}

/// Assembles a redundant group, at least to the digits of its file.
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

/// Moves every group a little along its freedoms and assembles it anew. nearly: redundant groups
/// may close only to the digits of their file.
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

/// Returns by how much rounding of positions may change the derivatives of rows, relative to them:
/// rounding over the lengths of small bodies. Those of linear equations are constant.
VectorXd uncertainty(const Model& m, const std::vector<double>& state, const GroupSystem& s) {
  constexpr double unit = 0x1p-52;
  const CharacteristicLengths lengths(m);
  VectorXd result = VectorXd::Zero(static_cast<Eigen::Index>(s.rows.size()));
  for (std::size_t r = 0; r < s.rows.size(); ++r) {
    const Constraint& c = m.constraints[s.rows[r].first];
    bool linear = false;
    visit_kind(c.kind, [&](auto kind) { linear = kind.linear; });
    if (linear) continue;
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

/// Replaces a definition of several equations by its single one. Returns whether it has one.
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

JudgedJacobians judged_jacobians(const GroupSystem& s, const JudgedPositions& positions,
                                 Linearisers& linearisers) {
  JudgedJacobians jacobians;
  for (std::size_t p = 0; p < positions.size(); ++p)
    jacobians[p] = linearisers.usual.at(positions[p], s).jacobian;
  return jacobians;
}

}  // namespace

RowSelector::RowSelector(CandidateEquations& candidates, const JudgedPositions& positions,
                         Linearisers& linearisers)
    : m_(candidates.model),
      origins_(candidates.origins),
      positions_(positions),
      linearisers_(linearisers),
      moves_(m_.state_size()) {
  for (EntityId e = 0; e < static_cast<EntityId>(m_.entities.size()); ++e)
    std::fill_n(moves_.begin() + m_.state_index(e), m_.entities[e].size, !m_.is_at_rest(e));
}

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

/// At the most general of the positions, the perturbed ones first, for a pose with lower rank is a
/// special one.
SelectedRows RowSelector::select(const GroupSystem& s) {
  SelectedRows selected;
  selected.jacobians = judged_jacobians(s, positions_, linearisers_);
  const std::vector<int> order = preference(s);
  int best_rank = -1;
  const auto take_rows = [&](const Eigen::MatrixXd& jacobian, const std::vector<bool>& among,
                             const VectorXd& uncertain) {
    std::vector<bool> taken(s.rows.size(), false);
    RowSpace space(s, s.unknowns);
    for (const int i : order)
      if (among[i])
        taken[i] = space.add(jacobian.row(i).head(s.unknowns).transpose(), uncertain[i]);
    return std::pair(space.rank(), std::move(taken));
  };
  const VectorXd certain = VectorXd::Zero(static_cast<Eigen::Index>(s.rows.size()));
  const auto take = [&](int p, const std::vector<bool>& among) {
    return take_rows(selected.jacobians[p], among, certain);
  };
  const std::vector<bool> all(s.rows.size(), true);
  for (const int p : {1, 2, 0}) {
    auto [rank, taken] = take(p, all);
    if (rank <= best_rank) continue;
    best_rank = rank;
    selected.taken = std::move(taken);
    if (best_rank == s.unknowns) break;
  }
  // A small body on a large one may look free by the lengths of the large one.
  if (best_rank < s.unknowns) {
    const Linearisation small = linearisers_.of_small.at(positions_[0], s);
    const VectorXd uncertain = uncertainty(m_, positions_[0], s);
    if (auto [rank, taken] = take_rows(small.jacobian, all, uncertain); rank == s.unknowns)
      selected.taken = std::move(taken);
    else if (uncertain.size() > 0)
      selected.uncertain = uncertain.maxCoeff();
  }
  if (std::ranges::find(selected.taken, false) == selected.taken.end()) return selected;
  // Prefers rows that also serve in the nominal position, where a motion may rest.
  if (auto [rank, taken] = take(0, all);
      rank == s.unknowns && take(0, selected.taken).first < rank && take(1, taken).first == rank)
    selected.taken = std::move(taken);
  return selected;
}

/// Rows, in the order in which they are taken.
std::vector<int> RowSelector::preference(const GroupSystem& s) const {
  using Rank = std::tuple<bool, bool, int, Origin, int>;
  std::vector<Rank> ranks;
  for (int c = s.first_constraint; c < s.end_constraint; ++c) {
    const Constraint& constraint = m_.constraints[c];
    std::vector<int> entries(rows(constraint), 0);
    visit_incidence(m_, constraint, [&](int row, int state) { entries[row] += moves_[state]; });
    bool linear = false;
    visit_kind(constraint.kind, [&](auto kind) { linear = kind.linear; });
    for (const int n : entries)
      ranks.emplace_back(constraint.derives < 0, !linear, n, origins_[c],
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

int mobility(const GroupSystem& s, const JudgedJacobians& jacobians) {
  const int columns = static_cast<int>(s.columns.size());
  int rank = 0;
  for (const Eigen::MatrixXd& jacobian : jacobians) {
    RowSpace space(s, columns);
    for (int i = 0; i < jacobian.rows(); ++i) space.add(jacobian.row(i).transpose());
    rank = std::max(rank, space.rank());
  }
  return columns - rank;
}

namespace {

JudgedPositions assembled(const Model& m, std::vector<GroupSystem>& systems,
                          Linearisers& linearisers) {
  JudgedPositions positions;
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

JudgedPositions assemble_positions(const Model& m, std::vector<GroupSystem>& systems,
                                   Linearisers& linearisers) {
  const JudgedPositions positions = assembled(m, systems, linearisers);
  bool again = false;
  for (GroupSystem& s : systems) {
    if (!s.redundant || s.closes_nearly() || s.drivers() == 0) continue;
    const JudgedJacobians jacobians = judged_jacobians(s, positions, linearisers);
    GroupSystem nearly = s;
    nearly.dependent_below = max_misfit;
    if (mobility(s, jacobians) >= s.drivers() || mobility(nearly, jacobians) < s.drivers())
      continue;
    s = nearly;
    again = true;
  }
  return again ? assembled(m, systems, linearisers) : positions;
}

}  // namespace desmo
