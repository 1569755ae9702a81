#include "formulations/modelling/independence.h"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <random>
#include <stdexcept>
#include <tuple>
#include <type_traits>

#include "formulations/incidence.h"

namespace desmo {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double dependent_below = 1e-6;  // what is left of a unit row, beside those taken before
constexpr int positions = 3;              // the nominal one and two perturbed ones

/// One group's candidates as rows, its unknowns and then its drivers as columns.
struct GroupSystem {
  GroupId group;
  int first_constraint, end_constraint;
  std::vector<int> columns;  // coordinates: the unknowns, then the drivers
  int unknowns = 0;
  std::vector<std::pair<int, int>> rows;  // constraint and its row

  int drivers() const { return static_cast<int>(columns.size()) - unknowns; }
};

/// Rows chosen one by one, each if it is independent of those before.
class RowSpace {
 public:
  explicit RowSpace(int columns) : basis_(columns, columns) {}

  /// Whether a row of length at most 1 is new; if so it joins.
  bool add(VectorXd row) {
    if (rank_ == basis_.cols()) return false;
    for (int pass = 0; pass < 2; ++pass)
      row -= basis_.leftCols(rank_) * (basis_.leftCols(rank_).transpose() * row);
    const double rest = row.norm();
    if (!(rest > dependent_below)) return false;
    basis_.col(rank_++) = row / rest;
    return true;
  }
  int rank() const { return rank_; }

 private:
  MatrixXd basis_;
  int rank_ = 0;
};

class Selector {
 public:
  Selector(Candidates& candidates, double size, const std::vector<int>& surplus)
      : candidates_(candidates), m_(candidates.mechanism), surplus_(surplus) {
    scale_.assign(m_.state_size(), 1.0);
    moves_.assign(m_.state_size(), 0);
    for (EntityId e = 0; e < static_cast<EntityId>(m_.entities.size()); ++e) {
      const EntityKind kind = m_.entities[e].kind;
      for (int i = m_.state_index(e); i < m_.state_index(e) + m_.entities[e].size; ++i) {
        if (kind == EntityKind::point || kind == EntityKind::distance) scale_[i] = size;
        moves_[i] = !m_.rests(e);
      }
    }
    column_.assign(m_.state_size(), -1);
    list_systems();
  }

  std::vector<LeftOut> run() {
    assemble_all();
    std::vector<LeftOut> left_out;
    for (GroupSystem& s : systems_) {
      const std::vector<bool> kept = select_and_shorten(s);
      require_square(s, kept);
      mark_left_out(s, kept, left_out);
    }
    remove_marked();
    return left_out;
  }

 private:
  void list_systems() {
    const std::vector<bool> independent = independent_coordinates(m_);
    systems_.resize(m_.groups.size());
    for (GroupId g = 0; g < static_cast<GroupId>(systems_.size()); ++g) systems_[g].group = g;
    std::vector<std::vector<int>> drivers(m_.groups.size());
    for (const Entity& e : m_.entities)
      for (int i = e.first; !e.fixed && i < e.first + e.size; ++i)
        (independent[i] ? drivers[e.group] : systems_[e.group].columns).push_back(i);
    for (GroupSystem& s : systems_) {
      s.unknowns = static_cast<int>(s.columns.size());
      s.columns.insert(s.columns.end(), drivers[s.group].begin(), drivers[s.group].end());
    }
    int c = 0;
    for (GroupSystem& s : systems_) {
      s.first_constraint = c;
      while (c < static_cast<int>(m_.constraints.size()) && m_.constraints[c].group == s.group) ++c;
      s.end_constraint = c;
      list_rows(s);
    }
  }

  void list_rows(GroupSystem& s) const {
    s.rows.clear();
    for (int c = s.first_constraint; c < s.end_constraint; ++c)
      for (int r = 0; r < desmo::rows(m_.constraints[c]); ++r) s.rows.emplace_back(c, r);
  }

  /// Φ and Φ_q of a group's candidates, in columns of natural magnitude; rows have length 1 over
  /// all they read.
  void evaluate(const GroupSystem& s, const std::vector<double>& state, VectorXd& phi,
                MatrixXd& jacobian) {
    const int n = static_cast<int>(s.rows.size());
    phi.resize(n);
    jacobian.setZero(n, static_cast<int>(s.columns.size()));
    VectorXd length2 = VectorXd::Zero(n);
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
  }

  /// Gauss–Newton with the smallest correction, over unknowns and drivers: assembles from an
  /// estimate even where equations depend on each other. Returns whether Φ vanishes.
  bool assemble(const GroupSystem& s, std::vector<double>& state) {
    constexpr int most = 100;
    VectorXd phi;
    MatrixXd jacobian;
    for (int iteration = 0; iteration < most; ++iteration) {
      evaluate(s, state, phi, jacobian);
      if (!phi.allFinite() || !jacobian.allFinite()) return false;
      if (phi.size() == 0 || phi.lpNorm<Eigen::Infinity>() < 1e-13) return true;
      const VectorXd step = decompose(jacobian).solve(phi);
      for (std::size_t j = 0; j < s.columns.size(); ++j)
        state[s.columns[j]] -= scale_[s.columns[j]] * step[j];
      if (!(step.norm() > 1e-14)) break;
    }
    return phi.lpNorm<Eigen::Infinity>() < 1e-9;
  }

  static Eigen::CompleteOrthogonalDecomposition<MatrixXd> decompose(const MatrixXd& jacobian) {
    Eigen::CompleteOrthogonalDecomposition<MatrixXd> decomposition;
    decomposition.setThreshold(dependent_below);
    decomposition.compute(jacobian);
    return decomposition;
  }

  void assemble_all() {
    states_[0] = m_.estimate;
    states_[0].insert(states_[0].end(), m_.fixed_values.begin(), m_.fixed_values.end());
    for (const GroupSystem& s : systems_)
      if (!assemble(s, states_[0])) refuse_assembly(s);
    for (int p = 1; p < positions; ++p) {
      states_[p] = states_[0];
      for (double amount = 0.02; amount > 0.002; amount /= 2)
        if (perturb_all(p, amount)) break;
    }
  }

  /// Moves every group a little along its freedoms and assembles it anew; where that cannot be
  /// done, the position is left as the nominal one.
  bool perturb_all(int p, double amount) {
    std::vector<double> state = states_[0];
    std::mt19937 random(p);
    VectorXd phi;
    MatrixXd jacobian;
    for (const GroupSystem& s : systems_) {
      evaluate(s, state, phi, jacobian);
      VectorXd move(s.columns.size());
      for (double& x : move) x = amount * (random() / 2147483648.0 - 1);
      if (jacobian.size() > 0) move -= decompose(jacobian).solve(jacobian * move);
      for (std::size_t j = 0; j < s.columns.size(); ++j)
        state[s.columns[j]] += scale_[s.columns[j]] * move[j];
      if (!assemble(s, state)) return false;
    }
    states_[p] = std::move(state);
    return true;
  }

  /// Positions in rows, in the order in which they are taken.
  std::vector<int> preference(const GroupSystem& s) const {
    using Rank = std::tuple<bool, int, Origin, int>;
    std::vector<Rank> ranks;
    for (int c = s.first_constraint; c < s.end_constraint; ++c) {
      const Constraint& constraint = m_.constraints[c];
      std::vector<int> entries(desmo::rows(constraint), 0);
      visit_incidence(m_, constraint, [&](int row, int state) { entries[row] += moves_[state]; });
      bool linear = false;
      visit_kind(constraint.kind, [&](auto kind) { linear = kind.linear; });
      for (const int n : entries)
        ranks.emplace_back(!linear, n, candidates_.origins[c], static_cast<int>(ranks.size()));
    }
    std::ranges::sort(ranks);
    std::vector<int> order;
    for (const Rank& r : ranks) order.push_back(std::get<3>(r));
    return order;
  }

  /// For each row, whether it is taken: at the most general of the positions, the perturbed ones
  /// first, for a pose with lower rank is a special one.
  std::vector<bool> select(const GroupSystem& s) {
    VectorXd phi;
    for (int p = 0; p < positions; ++p) evaluate(s, states_[p], phi, jacobians_[p]);
    const std::vector<int> order = preference(s);
    std::vector<bool> best;
    int best_rank = -1;
    for (const int p : {1, 2, 0}) {
      std::vector<bool> taken(s.rows.size(), false);
      RowSpace space(s.unknowns);
      for (const int i : order)
        taken[i] = space.add(jacobians_[p].row(i).head(s.unknowns).transpose());
      if (space.rank() <= best_rank) continue;
      best_rank = space.rank();
      best = std::move(taken);
      if (best_rank == s.unknowns) break;
    }
    return best;
  }

  /// Like select. A definition of which one equation would be taken is replaced by the one equation
  /// that says the same: of the sine and the cosine of an angle, either is singular somewhere.
  std::vector<bool> select_and_shorten(GroupSystem& s) {
    std::vector<bool> taken = select(s);
    for (;;) {
      const auto first = m_.constraints.begin() + s.first_constraint,
                 end = m_.constraints.begin() + s.end_constraint;
      const std::vector<Constraint> before(first, end);
      if (!shorten_definitions(s, taken)) return taken;
      list_rows(s);
      std::vector<bool> shortened = select(s);
      if (std::ranges::count(shortened, true) < std::ranges::count(taken, true)) {
        std::ranges::copy(before, first);
        list_rows(s);
        return select(s);
      }
      taken = std::move(shortened);
    }
  }

  /// Whether there was any.
  bool shorten_definitions(const GroupSystem& s, const std::vector<bool>& taken) {
    std::vector<int> rows_taken(s.end_constraint - s.first_constraint, 0);
    for (std::size_t i = 0; i < taken.size(); ++i)
      rows_taken[s.rows[i].first - s.first_constraint] += taken[i];
    bool any = false;
    for (int c = s.first_constraint; c < s.end_constraint; ++c)
      if (rows_taken[c - s.first_constraint] == 1) any = shorten(m_.constraints[c]) || any;
    return any;
  }

  static bool shorten(Constraint& constraint) {
    bool shorter = false;
    visit_kind(constraint.kind, [&]<class Kind>(Kind) {
      using Scalar = typename ScalarDefinition<Kind>::type;
      if constexpr (!std::is_void_v<Scalar>) {
        constraint.kind = kind_index<Scalar>();
        constraint.constants.resize(Scalar::constants);
        shorter = true;
      }
    });
    return shorter;
  }

  /// Freedoms that the candidates leave to a group, drivers free, at the most general position.
  int mobility(const GroupSystem& s) const {
    int rank = 0;
    for (int p = 0; p < positions; ++p) {
      RowSpace space(static_cast<int>(s.columns.size()));
      for (int i = 0; i < jacobians_[p].rows(); ++i) space.add(jacobians_[p].row(i).transpose());
      rank = std::max(rank, space.rank());
    }
    return static_cast<int>(s.columns.size()) - rank;
  }

  std::string where(const GroupSystem& s) const {
    constexpr std::size_t shown = 6;
    const std::vector<std::string>& bodies = m_.groups[s.group].bodies;
    std::string text = m_.name + ", group '" + m_.groups[s.group].name + "' (";
    for (std::size_t i = 0; i < bodies.size() && i < shown; ++i)
      text += (i == 0 ? "" : ", ") + bodies[i];
    return text + (bodies.size() > shown ? ", …): " : "): ");
  }

  std::string driver_names(const GroupSystem& s) const {
    const std::vector<EntityId> owner = entity_of_coordinate(m_);
    std::string text;
    for (std::size_t j = s.unknowns; j < s.columns.size(); ++j)
      text += (text.empty() ? "'" : ", '") + m_.entities[owner[s.columns[j]]].name + "'";
    return text;
  }

  void require_square(const GroupSystem& s, const std::vector<bool>& kept) {
    const int count = static_cast<int>(std::ranges::count(kept, true));
    const bool some_left = count < static_cast<int>(kept.size());
    if (count == s.unknowns && (!some_left || s.drivers() == 0)) return;
    const int freedoms = mobility(s);
    if (freedoms < s.drivers())
      throw std::invalid_argument(
          where(s) + "over-constrained: " + std::to_string(freedoms) + " freedom" +
          (freedoms == 1 ? "" : "s") + " for " + std::to_string(s.drivers()) + " driver" +
          (s.drivers() == 1 ? "" : "s") + " (" + driver_names(s) +
          "); too many drivers, or constraints that contradict each other as it moves");
    if (count == s.unknowns) return;
    if (freedoms > s.drivers()) {
      throw std::invalid_argument(
          where(s) + "under-constrained: " + std::to_string(freedoms - s.drivers()) + " freedom" +
          (freedoms - s.drivers() == 1 ? "" : "s") + " not determined by any joint or driver ('" +
          loosest(s) + "' can still move); add a driver or a joint");
    }
    const std::string drivers =
        s.drivers() > 0 ? "its drivers (" + driver_names(s) + ") do" : "what comes before it does";
    throw std::invalid_argument(where(s) + drivers + " not determine it: '" + loosest(s) +
                                "' can still move while all that is held; drive other coordinates");
  }

  /// The entity that moves most when all candidates and drivers hold.
  std::string loosest(const GroupSystem& s) const {
    const MatrixXd j = jacobians_[1].leftCols(s.unknowns);
    VectorXd best = VectorXd::Zero(s.unknowns);
    const auto decomposition = decompose(j);
    for (int k = 0; k < s.unknowns; ++k) {
      VectorXd move = VectorXd::Unit(s.unknowns, k);
      if (j.size() > 0) move -= decomposition.solve(j * move);
      if (move.norm() > best.norm()) best = move;
    }
    Eigen::Index largest = 0;
    best.cwiseAbs().maxCoeff(&largest);
    return m_.entities[entity_of_coordinate(m_)[s.columns[largest]]].name;
  }

  [[noreturn]] void refuse_assembly(const GroupSystem& s) {
    VectorXd phi;
    MatrixXd jacobian;
    evaluate(s, states_[0], phi, jacobian);
    Eigen::Index worst = 0;
    if (phi.allFinite()) phi.cwiseAbs().maxCoeff(&worst);
    throw std::invalid_argument(where(s) +
                                "cannot be assembled near its nominal position; constraint '" +
                                m_.constraints[s.rows[worst].first].name +
                                "' is satisfied worst; check the dimensions of these bodies");
  }

  void mark_left_out(const GroupSystem& s, const std::vector<bool>& kept,
                     std::vector<LeftOut>& left_out) {
    for (std::size_t i = 0; i < kept.size(); ++i) {
      if (kept[i]) continue;
      const auto [c, row] = s.rows[i];
      m_.constraints[c].left_out |= 1u << row;
      const bool another_row = !left_out.empty() && left_out.back().group == s.group &&
                               left_out.back().equation == m_.constraints[c].name;
      if (!another_row)
        left_out.push_back({m_.constraints[c].name, {}, s.group, {}, surplus_[s.group] > 0});
      left_out.back().rows.push_back(row);
      for (const std::string& name : sources(s, kept, static_cast<int>(i)))
        if (std::ranges::find(left_out.back().follows_from, name) ==
            left_out.back().follows_from.end())
          left_out.back().follows_from.push_back(name);
    }
  }

  /// The constraints of which a row is a combination.
  std::vector<std::string> sources(const GroupSystem& s, const std::vector<bool>& kept, int row) {
    const MatrixXd& j = jacobians_[1];
    std::vector<int> taken;
    for (std::size_t i = 0; i < kept.size(); ++i)
      if (kept[i]) taken.push_back(static_cast<int>(i));
    MatrixXd basis(s.unknowns, static_cast<int>(taken.size()));
    for (std::size_t k = 0; k < taken.size(); ++k)
      basis.col(k) = j.row(taken[k]).head(s.unknowns).transpose();
    std::vector<std::string> names;
    if (basis.size() == 0) return names;
    const VectorXd weights =
        basis.colPivHouseholderQr().solve(j.row(row).head(s.unknowns).transpose());
    for (std::size_t k = 0; k < taken.size(); ++k) {
      const std::string& name = m_.constraints[s.rows[taken[k]].first].name;
      if (std::abs(weights[k]) > dependent_below && (names.empty() || names.back() != name))
        names.push_back(name);
    }
    return names;
  }

  void remove_marked() {
    std::vector<Constraint> constraints;
    std::vector<Origin> origins;
    for (std::size_t c = 0; c < m_.constraints.size(); ++c) {
      if (kept_rows(m_.constraints[c]) == 0) continue;
      constraints.push_back(std::move(m_.constraints[c]));
      origins.push_back(candidates_.origins[c]);
    }
    m_.constraints = std::move(constraints);
    candidates_.origins = std::move(origins);
  }

  Candidates& candidates_;
  Mechanism& m_;
  const std::vector<int>& surplus_;
  std::vector<double> scale_;  // natural magnitude of each component of the state
  std::vector<char> moves_;    // whether it does
  std::vector<int> column_;    // of each component in the group at hand, or -1
  std::vector<GroupSystem> systems_;
  std::array<std::vector<double>, positions> states_;
  std::array<MatrixXd, positions> jacobians_;  // of the group at hand
};

}  // namespace

std::vector<LeftOut> leave_out_dependent(Candidates& candidates, double size,
                                         const std::vector<int>& surplus) {
  return Selector(candidates, size, surplus).run();
}

}  // namespace desmo
