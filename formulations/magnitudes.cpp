#include "formulations/magnitudes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace desmo {

namespace {

/// Of its second-order change, what an equation without a derivative is judged by: links down to
/// this fraction of the bodies they join keep their own magnitude.
constexpr double least_share = 1e-3;

bool is_length(const Entity& e) {
  return e.kind == EntityKind::point || e.kind == EntityKind::distance;
}

std::vector<double> nominal_state(const Mechanism& m) {
  std::vector<double> state = m.estimate;
  state.insert(state.end(), m.fixed_values.begin(), m.fixed_values.end());
  return state;
}

/// The largest distance between points of a constraint, or of its distance operands.
double extent(const Mechanism& m, const Constraint& c, const std::vector<double>& state) {
  double largest = 0;
  const auto at_least = [&](double length) {
    if (length > largest && std::isfinite(length)) largest = length;
  };
  for (const EntityId a : c.operands) {
    const double* x = state.data() + m.state_index(a);
    if (m.entities[a].kind == EntityKind::distance) at_least(std::abs(*x));
    if (m.entities[a].kind != EntityKind::point) continue;
    for (const EntityId b : c.operands) {
      if (m.entities[b].kind != EntityKind::point) continue;
      const double* y = state.data() + m.state_index(b);
      double distance = 0;
      for (int i = 0; i < m.entities[a].size; ++i) distance = std::hypot(distance, y[i] - x[i]);
      at_least(distance);
    }
  }
  return largest;
}

/// The length by which each constraint's points and distances are judged.
std::vector<double> characteristic_lengths(const Mechanism& m, const std::vector<double>& state) {
  const std::size_t n = m.constraints.size();
  std::vector<double> about(m.entities.size()), of_group(m.groups.size()), result(n);
  double of_all = 0;
  for (const Constraint& c : m.constraints) {
    const double length = extent(m, c, state);
    for (const EntityId e : c.operands) about[e] = std::max(about[e], length);
    of_group[c.group] = std::max(of_group[c.group], length);
    of_all = std::max(of_all, length);
  }
  for (std::size_t k = 0; k < n; ++k) {
    const Constraint& c = m.constraints[k];
    for (const EntityId e : c.operands)
      if (is_length(m.entities[e])) result[k] = std::max(result[k], about[e]);
    for (const double wider : {of_group[c.group], of_all, 1.0})
      if (result[k] == 0) result[k] = wider;
  }
  return result;
}

/// Of each row of a constraint, whose lengths are about `length`.
template <class Kind>
std::array<double, Kind::rows> magnitudes(Kind, const Mechanism& m, const Constraint& c,
                                          const std::vector<double>& state, double length) {
  constexpr std::size_t operands = Kind::operand_sizes.size();
  std::array<double, operands> size;
  std::array<std::array<double, 3>, operands> move;  // a little of everything, to and fro
  std::array<const double*, operands> x, v;
  for (std::size_t k = 0; k < operands; ++k) {
    size[k] = is_length(m.entities[c.operands[k]]) ? length : 1;
    move[k].fill((k % 2 == 0 ? size[k] : -size[k]) / std::sqrt(Kind::operand_sizes[k]));
    x[k] = state.data() + m.state_index(c.operands[k]);
    v[k] = move[k].data();
  }
  std::array<double, Kind::rows> result{}, second;
  Kind::jacobian(x.data(), c.constants.data(), [&](int row, int operand, int, double value) {
    result[row] = std::hypot(result[row], value * size[operand]);
  });
  Kind::quadratic(x.data(), v.data(), c.constants.data(), second.data());
  for (int row = 0; row < Kind::rows; ++row) {
    result[row] = std::max(result[row], least_share * std::abs(second[row]) / 2);
    if (!(result[row] > 0) || !std::isfinite(result[row])) result[row] = 1;
  }
  return result;
}

}  // namespace

Magnitudes::Magnitudes(const Mechanism& m) {
  const std::vector<double> state = nominal_state(m);
  const std::vector<double> length = characteristic_lengths(m, state);
  for (std::size_t k = 0; k < m.constraints.size(); ++k) {
    const Constraint& c = m.constraints[k];
    first_row_.push_back(static_cast<int>(magnitude_.size()));
    visit_kind(c.kind, [&](auto kind) {
      const auto rows = magnitudes(kind, m, c, state, length[k]);
      magnitude_.insert(magnitude_.end(), rows.begin(), rows.end());
    });
  }
}

std::vector<double> Magnitudes::weights(const PartDefinition& part) const {
  std::vector<double> result;
  for (const Equation& e : part.equations) result.push_back(1 / of(e));
  return result;
}

}  // namespace desmo
