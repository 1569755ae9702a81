#include "formulations/modelling/independence/refusal.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "formulations/scaling/characteristic_lengths.h"
#include "formulations/scaling/scales.h"

namespace desmo {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

std::string where(const Model& m, const GroupSystem& s) {
  constexpr std::size_t shown = 6;
  const std::vector<std::string>& bodies = m.groups[s.group].bodies;
  std::string text = m.name + ", group '" + m.groups[s.group].name + "' (";
  for (std::size_t i = 0; i < bodies.size() && i < shown; ++i)
    text += (i == 0 ? "" : ", ") + bodies[i];
  return text + (bodies.size() > shown ? ", …): " : "): ");
}

std::string driver_names(const Model& m, const GroupSystem& s) {
  const std::vector<EntityId> owner = entity_of_coordinate(m);
  std::string text;
  for (std::size_t j = s.unknowns; j < s.columns.size(); ++j)
    text += (text.empty() ? "'" : ", '") + m.entities[owner[s.columns[j]]].name + "'";
  return text;
}

std::string counted(int n, const std::string& what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

/// Freedoms that the candidates leave to a group, drivers free, at the most general position.
int mobility(const GroupSystem& s, const SelectedRows& selected) {
  int rank = 0;
  for (const MatrixXd& jacobian : selected.jacobians) {
    RowSpace space(static_cast<int>(s.columns.size()));
    for (int i = 0; i < jacobian.rows(); ++i) space.add(jacobian.row(i).transpose());
    rank = std::max(rank, space.rank());
  }
  return static_cast<int>(s.columns.size()) - rank;
}

/// The entity that moves most when all candidates and drivers hold.
std::string loosest(const Model& m, const GroupSystem& s, const SelectedRows& selected) {
  const MatrixXd j = selected.jacobians[1].leftCols(s.unknowns);
  MatrixXd moves = MatrixXd::Identity(s.unknowns, s.unknowns);  // by one unknown each
  if (j.size() > 0) moves -= smallest_correction(j, j);
  Eigen::Index loosest = 0;
  moves.colwise().norm().maxCoeff(&loosest);
  Eigen::Index largest = 0;
  moves.col(loosest).cwiseAbs().maxCoeff(&largest);
  return m.entities[entity_of_coordinate(m)[s.columns[largest]]].name;
}

/// "with its drivers ('theta') moved by 0.01, 'rod/length' is off by 1.2e-08 m at best"
std::string described(const Contradiction& c, const Model& m, const GroupSystem& s) {
  char moved[24], amount[24];
  std::snprintf(moved, sizeof moved, "%g", c.moved);
  std::snprintf(amount, sizeof amount, "%.1e", c.amount);
  const Constraint& constraint = m.constraints[c.constraint];
  const bool has_unit =
      m.length_unit != "1" && std::ranges::any_of(constraint.operands, [&](EntityId e) {
        return is_length(m.entities[e].kind);
      });
  return "with its drivers (" + driver_names(m, s) + ") moved by " + moved + ", '" +
         constraint.name + "' is off by " + amount + (has_unit ? " " + m.length_unit : "") +
         " at best";
}

/// "rounding of its positions is 2e-06 of the shortest of its lengths"
std::string unclear(double uncertain) {
  char share[16];
  std::snprintf(share, sizeof share, "%.0e", uncertain);
  return std::string("rounding of its positions is ") + share + " of the shortest of its lengths";
}

}  // namespace

void refuse_assembly(const Model& m, const GroupSystem& s, const VectorXd& phi) {
  Eigen::Index worst = 0;
  if (phi.allFinite()) phi.cwiseAbs().maxCoeff(&worst);
  throw std::invalid_argument(where(m, s) +
                              "cannot be assembled near its nominal position; constraint '" +
                              m.constraints[s.rows[worst].first].name +
                              "' is satisfied worst; check the dimensions of these bodies");
}

void require_determined(const Model& m, const GroupSystem& s, const SelectedRows& selected,
                        const std::optional<Contradiction>& contradiction) {
  const int count = static_cast<int>(std::ranges::count(selected.taken, true));
  const bool some_left = count < static_cast<int>(selected.taken.size());
  if (count == s.unknowns && (!some_left || s.drivers() == 0)) return;
  const int freedoms = mobility(s, selected);
  if (freedoms < s.drivers())
    throw std::invalid_argument(
        where(m, s) + "over-constrained: " + counted(freedoms, "freedom") + " for " +
        counted(s.drivers(), "driver") + " (" + driver_names(m, s) +
        "); too many drivers, or constraints that contradict each other as it moves" +
        (contradiction ? ": " + described(*contradiction, m, s) : ""));
  if (count == s.unknowns && contradiction)
    throw std::invalid_argument(where(m, s) +
                                "inconsistent: constraints contradict each other as it moves: " +
                                described(*contradiction, m, s));
  if (count == s.unknowns) return;
  if (uncertainty_margin * selected.uncertain > dependent_below)
    throw std::invalid_argument(
        where(m, s) + unclear(selected.uncertain) + ", so that it cannot be told whether '" +
        loosest(m, s, selected) +
        "' is determined; place it nearer to the origin, or let its lengths differ less");
  if (freedoms > s.drivers())
    throw std::invalid_argument(
        where(m, s) + "under-constrained: " + counted(freedoms - s.drivers(), "freedom") +
        " not determined by any joint or driver ('" + loosest(m, s, selected) +
        "' can still move); add a driver or a joint");
  const std::string drivers =
      s.drivers() > 0 ? "its drivers (" + driver_names(m, s) + ") do" : "what comes before it does";
  throw std::invalid_argument(where(m, s) + drivers + " not determine it: '" +
                              loosest(m, s, selected) +
                              "' can still move while all that is held; drive other coordinates");
}

}  // namespace desmo
