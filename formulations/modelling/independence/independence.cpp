#include "formulations/modelling/independence/independence.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "cases/mechanism/names.h"
#include "formulations/model/characteristic_lengths.h"
#include "formulations/model/misfit.h"
#include "formulations/modelling/contradiction_error.h"
#include "formulations/modelling/independence/refusal.h"
#include "formulations/modelling/independence/row_selection.h"

namespace desmo {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Movement of the drivers [natural magnitudes]. It is so large that a contradiction shows
/// although other bodies give way to first order.
constexpr double driver_movement = 0.1;
/// Steps of this movement, each near enough for Newton's method; an even number.
constexpr int movement_steps = 10;

/// Minimises Φ over the unknowns by the Gauss–Newton method. Overwrites the state; returns what
/// is left of Φ, relative to its scales.
VectorXd minimise_residual(std::vector<double>& state, const GroupSystem& s,
                           Lineariser& lineariser) {
  constexpr int max_iterations = 50;
  constexpr double max_residual = 1e-12;  // relative |Φ| ≤ this: Φ vanishes
  for (int iteration = 0;; ++iteration) {
    const Linearisation now = lineariser.at(state, s);
    const VectorXd residual = now.relative_phi();
    if (iteration == max_iterations || !residual.allFinite() ||
        !(residual.lpNorm<Eigen::Infinity>() > max_residual))
      return residual;
    VectorXd step = VectorXd::Zero(static_cast<Eigen::Index>(s.columns.size()));
    step.head(s.unknowns) = -smallest_correction(s, now.jacobian.leftCols(s.unknowns), now.phi);
    if (!(step.norm() > 1e-14)) return residual;
    lineariser.move(state, s, step);
  }
}

/// Returns the misfits of a movement m = 1 [natural magnitude], extrapolated as a m + b m² from
/// those of m = driver_movement (whole) and of half of it (half).
VectorXd extrapolated(const VectorXd& half, const VectorXd& whole) {
  return (4 * half - whole) / driver_movement +
         (2 * whole - 4 * half) / (driver_movement * driver_movement);
}

/// Returns the other constraints that contradict the one that is off most: those with a residual
/// > max_misfit. At the least-squares position, rows have residuals when they depend on each other.
std::vector<int> contradicted(const GroupSystem& s, const VectorXd& misfits, int constraint) {
  std::vector<int> others;
  for (std::size_t i = 0; i < s.rows.size(); ++i) {
    const int other = s.rows[i].first;
    if (other == constraint || (!others.empty() && others.back() == other)) continue;
    if (std::abs(misfits[i]) > max_misfit) others.push_back(other);
  }
  return others;
}

/// Moves a group's drivers a little from an assembled position, first forwards, then backwards.
/// Returns nullopt when all its candidates, dependent ones included, can follow in one direction.
/// Then misfits are ≤ max_misfit, also when extrapolated to a movement by one natural magnitude.
std::optional<Contradiction> find_contradiction(const GroupSystem& s,
                                                const std::vector<double>& position,
                                                Lineariser& lineariser) {
  if (s.unknowns == 0 || s.rows.empty()) return {};
  std::optional<Contradiction> found;
  for (const double movement :
       {driver_movement, -driver_movement}) {  // one of them may be out of reach
    VectorXd step = VectorXd::Zero(static_cast<Eigen::Index>(s.columns.size()));
    step.tail(s.drivers()).setConstant(movement / movement_steps);
    std::vector<double> state = position;
    VectorXd half, whole;
    for (int i = 1; i <= movement_steps; ++i) {
      lineariser.move(state, s, step);
      whole = minimise_residual(state, s, lineariser);
      if (i == movement_steps / 2) half = whole;
    }
    Eigen::Index worst = 0;
    const double worst_misfit = whole.cwiseAbs().maxCoeff<Eigen::PropagateNaN>(&worst);
    if (worst_misfit <= max_misfit && extrapolated(half, whole).cwiseAbs().maxCoeff() <= max_misfit)
      return {};
    if (found && !std::isfinite(worst_misfit))
      continue;  // e.g. outside of a table: the first direction tells more
    const int constraint = s.rows[worst].first;
    found = {constraint, worst_misfit, movement, contradicted(s, whole, constraint)};
  }
  return found;
}

/// Returns the names of the constraints whose selected rows a row is a combination of.
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
  const VectorXd weights = smallest_correction(s, basis, j.row(row).head(s.unknowns).transpose());
  for (std::size_t k = 0; k < taken.size(); ++k) {
    const std::string& name = m.constraints[s.rows[taken[k]].first].name;
    if (std::abs(weights[k]) > dependent_below && (names.empty() || names.back() != name))
      names.push_back(name);
  }
  return names;
}

/// Marks the rows of the model that were not selected, and lists them with the constraints that
/// they follow from.
void mark_left_out(Model& m, const GroupSystem& s, const SelectedRows& selected,
                   std::vector<LeftOut>& left_out) {
  for (std::size_t i = 0; i < selected.taken.size(); ++i) {
    if (selected.taken[i]) continue;
    const auto [c, row] = s.rows[i];
    m.constraints[c].left_out |= 1u << row;
    const bool another_row = !left_out.empty() && left_out.back().group == s.group &&
                             left_out.back().equation == m.constraints[c].name;
    if (!another_row) left_out.push_back({m.constraints[c].name, {}, s.group, {}, s.redundant});
    left_out.back().rows.push_back(row);
    for (const std::string& name : sources(m, s, selected, static_cast<int>(i)))
      if (std::ranges::find(left_out.back().follows_from, name) ==
          left_out.back().follows_from.end())
        left_out.back().follows_from.push_back(name);
  }
}

/// Returns the equations between constants. Candidates contain those that do not hold to rounding.
/// Throws ContradictionError when one is off by more than max_misfit of its length.
std::vector<LeftOut> constant_equations(const Model& m) {
  const std::vector<double> state = m.state_of(m.estimate);
  const CharacteristicLengths lengths(m);
  std::vector<LeftOut> all;
  for (int c = 0; c < static_cast<int>(m.constraints.size()); ++c) {
    const Constraint& constraint = m.constraints[c];
    if (!is_constant(m, constraint)) continue;
    all.push_back({constraint.name, {}, constraint.group, {}, false});
    const std::vector<double> phi = residual_of(m, constraint, state);
    for (int row = 0; row < std::ssize(phi); ++row) {
      Misfit misfit = misfit_of(m, c, row, phi[row], state);
      misfit.relative = misfit.over(lengths.own(constraint));
      if (!(misfit.relative <= max_misfit))
        throw ContradictionError(
            [name = in_quotes(constraint.name), misfit](const DisplayUnits& units) {
              return name + " is off by " + in_unit(misfit.amount, misfit.unit(units)) +
                     ": the places on the ground and the shape of the body, or two shapes, "
                     "contradict each other; make them the same";
            },
            m.length_unit);
      all.back().rows.push_back(row);
      std::optional<Misfit>& largest = all.back().misfit;
      if (!largest || misfit.relative > largest->relative) largest = misfit;
    }
  }
  return all;
}

}  // namespace

std::vector<LeftOut> leave_out_dependent(Model& m, const std::vector<int>& surplus) {
  std::vector<LeftOut> left_out = constant_equations(m);
  std::vector<GroupSystem> systems = group_systems(m);
  for (GroupSystem& s : systems) s.redundant = surplus[s.group] > 0;
  Linearisers linearisers(m);
  const SampledPositions positions = assemble_positions(m, systems, linearisers);
  RowSelector selector(m, positions, linearisers);
  for (GroupSystem& s : systems) {
    SelectedRows selected = selector.select(s);
    std::optional<Contradiction> contradiction;
    if (s.redundant && s.drivers() > 0)
      contradiction = find_contradiction(s, positions[1], linearisers.usual);
    // Comes before definitions are shortened: the equation that replaces one may contradict
    // nothing.
    require_determined(m, s, selected, contradiction);
    selector.shorten(s, selected);
    mark_left_out(m, s, selected, left_out);
  }
  return left_out;
}

}  // namespace desmo
