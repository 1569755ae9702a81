#include "formulations/modelling/independence/refusal.h"

#include <algorithm>
#include <cmath>
#include <ranges>
#include <stdexcept>
#include <string>

#include "cases/mechanism/formatted.h"
#include "cases/mechanism/names.h"
#include "formulations/model/characteristic_lengths.h"
#include "formulations/model/scales.h"
#include "formulations/modelling/contradiction_error.h"

namespace desmo {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

std::string where(const Model& m, const GroupSystem& s) {
  constexpr int shown = 6;
  const std::vector<std::string>& bodies = m.groups[s.group].bodies;
  return m.name + ", group '" + m.groups[s.group].name + "' (" +
         joined(bodies | std::views::take(shown)) + (std::ssize(bodies) > shown ? ", …): " : "): ");
}

std::string driver_names(const Model& m, const GroupSystem& s) {
  const std::vector<EntityId> owner = entity_of_coordinate(m);
  return joined(s.columns | std::views::drop(s.unknowns),
                [&](int coordinate) { return "'" + m.entities[owner[coordinate]].name + "'"; });
}

std::string counted(int n, const std::string& what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

/// Returns the name of the entity that can move most while candidates hold and drivers rest.
std::string loosest(const Model& m, const GroupSystem& s, const SelectedRows& selected) {
  const MatrixXd j = selected.jacobians[1].leftCols(s.unknowns);
  // Column k: unknown k moves by 1; the others move so that candidates hold to first order.
  MatrixXd moves = MatrixXd::Identity(s.unknowns, s.unknowns);
  if (j.size() > 0) moves -= smallest_correction(s, j, j);
  Eigen::Index loosest = 0;
  moves.colwise().norm().maxCoeff(&loosest);
  Eigen::Index largest = 0;
  moves.col(loosest).cwiseAbs().maxCoeff(&largest);
  return m.entities[entity_of_coordinate(m)[s.columns[largest]]].name;
}

/// Throws ContradictionError: "…: with its drivers ('theta') moved by 0.1 rad, 'rod/length' is off
/// by 1.2e-08 m at best, against 'rod2/length'"
[[noreturn]] void refuse(const std::string& text, const Contradiction& c, const Model& m,
                         const GroupSystem& s) {
  const Constraint& constraint = m.constraints[c.constraint];
  const auto is_of_length = [&](EntityId e) { return is_length(m.entities[e].kind); };
  const auto is_angle = [&](EntityId e) { return m.entities[e].kind == EntityKind::angle; };
  const bool has_length = std::ranges::any_of(constraint.operands, is_of_length),
             has_angles = std::ranges::all_of(constraint.operands, is_angle);
  constexpr std::size_t shown = 4;
  std::string others;
  for (std::size_t i = 0; i < c.others.size() && i < shown; ++i)
    others += (i == 0 ? ", against '" : ", '") + m.constraints[c.others[i]].name + "'";
  if (c.others.size() > shown) others += ", …";
  const std::vector<EntityId> owner = entity_of_coordinate(m);
  const bool turns = std::none_of(s.columns.begin() + s.unknowns, s.columns.end(),
                                  [&](int coordinate) { return is_of_length(owner[coordinate]); });
  const double amount = c.amount * (has_length ? CharacteristicLengths(m).of(constraint) : 1);
  const std::string moved = text + ": with its drivers (" + driver_names(m, s) + ") moved by ",
                    what = ", '" + constraint.name + "' ";
  throw ContradictionError(
      [=, moved_by = c.moved](const DisplayUnits& units) {
        const std::string where =
            moved + in_unit(moved_by, turns ? units.angle : DisplayUnit{"of its size"}) + what;
        if (!std::isfinite(amount)) return where + "has no value, one way and the other";
        return where + "is off by " +
               in_unit(amount, has_length   ? units.length
                               : has_angles ? units.angle
                                            : DisplayUnit{"1"}) +
               " at best" + others;
      },
      m.length_unit);
}

}  // namespace

void refuse_assembly(const Model& m, const GroupSystem& s, const VectorXd& phi) {
  Eigen::Index worst = 0;
  if (phi.allFinite()) phi.cwiseAbs().maxCoeff(&worst);
  const Constraint& c = m.constraints[s.rows[worst].first];
  // Names all operands: an angle's definition, say, also fails for the length of its line.
  const std::string operands = joined(c.operands, [&](EntityId e) { return m.entities[e].name; });
  throw std::invalid_argument(
      where(m, s) + "cannot be assembled near its nominal position; constraint '" + c.name +
      "' (between " + operands + ") is satisfied worst; check the dimensions of these bodies");
}

void require_determined(const Model& m, const GroupSystem& s, const SelectedRows& selected,
                        const std::optional<Contradiction>& contradiction) {
  const int count = static_cast<int>(std::ranges::count(selected.taken, true));
  const bool some_left = count < static_cast<int>(selected.taken.size());
  if (count == s.unknowns && (!some_left || s.drivers() == 0)) return;
  const int freedoms = mobility(s, selected.jacobians);
  if (freedoms < s.drivers()) {
    const std::string text =
        where(m, s) + "over-constrained: " + counted(freedoms, "freedom") + " for " +
        counted(s.drivers(), "driver") + " (" + driver_names(m, s) +
        "); too many drivers, or constraints that contradict each other as it moves";
    if (contradiction) refuse(text, *contradiction, m, s);
    throw std::invalid_argument(text);
  }
  if (count == s.unknowns && contradiction)
    refuse(where(m, s) + "inconsistent: constraints contradict each other as it moves",
           *contradiction, m, s);
  if (count == s.unknowns) return;
  if (uncertainty_margin * selected.uncertain > dependent_below)
    throw std::invalid_argument(
        where(m, s) +
        formatted("rounding of its positions is %.0e of the shortest of its lengths",
                  selected.uncertain) +
        ", so that it cannot be told whether '" + loosest(m, s, selected) +
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
