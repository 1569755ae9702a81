#include "formulations/model/magnitudes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "formulations/model/characteristic_lengths.h"
#include "formulations/model/constraint_at.h"
#include "formulations/model/scales.h"

namespace desmo {

namespace {

/// Minimum magnitude of an equation, relative to its second-order change. It gives an equation
/// whose first derivatives vanish a magnitude. A distance that is longer than about this fraction
/// of its characteristic length keeps the magnitude of its first derivatives.
constexpr double min_share = 1e-3;

/// Returns the norm of an entity plus that of a motion: `length`, or 1 for directions and angles.
double reach(const Model& m, EntityId e, const double* x, double length) {
  const Entity& entity = m.entities[e];
  double norm = 0;
  for (int i = 0; i < entity.size; ++i) norm = std::hypot(norm, x[i]);
  return norm + (is_length(entity.kind) ? length : 1);
}

/// Magnitude and rounding error of each row of a constraint.
struct RowSizes {
  std::array<double, max_rows> magnitude{};
  std::array<double, max_rows> rounding{};  // u Σⱼ |∂Φ/∂qⱼ| |qⱼ|, u = 2⁻⁵³
};

/// Returns magnitude and rounding error of the rows of a constraint. length: its characteristic
/// length.
RowSizes row_sizes(const Model& m, const Constraint& c, const std::vector<double>& state,
                   double length) {
  constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;
  std::array<double, max_operands> size, change;
  std::array<std::array<double, max_components>, max_operands>
      move;  // displacement of each operand, signs alternating
  const ConstraintAt<double> at(m, c, state.data());
  std::array<const double*, max_operands> v{};
  for (std::size_t k = 0; k < c.operands.size(); ++k) {
    change[k] = unit_roundoff * reach(m, c.operands[k], at.x[k], length);
    size[k] = is_length(m.entities[c.operands[k]].kind) ? length : 1;
    move[k].fill((k % 2 == 0 ? size[k] : -size[k]) / std::sqrt(at.kind.operand_sizes[k]));
    v[k] = move[k].data();
  }
  RowSizes result;
  std::array<double, max_rows> second;
  at.jacobian([&](int row, int operand, int, double value) {
    result.magnitude[row] = std::hypot(result.magnitude[row], value * size[operand]);
    result.rounding[row] += std::abs(value) * change[operand];
  });
  at.quadratic(v, second.data());
  for (int row = 0; row < at.kind.rows; ++row) {
    double& magnitude = result.magnitude[row];
    magnitude = std::max(magnitude, min_share * std::abs(second[row]) / 2);
    if (!(magnitude > 0) || !std::isfinite(magnitude)) magnitude = 1;
  }
  return result;
}

}  // namespace

Magnitudes::Magnitudes(const Model& m) {
  const std::vector<double> state = m.state_of(m.estimate);
  const CharacteristicLengths lengths(m);
  of_coordinate_ = lengths.of_coordinates();
  for (const Constraint& c : m.constraints) {
    first_row_.push_back(static_cast<int>(magnitude_.size()));
    const auto [magnitude, rounding] = row_sizes(m, c, state, lengths.of(c));
    magnitude_.insert(magnitude_.end(), magnitude.begin(), magnitude.begin() + rows(c));
    rounding_.insert(rounding_.end(), rounding.begin(), rounding.begin() + rows(c));
  }
}

double Magnitudes::rounding(const PartDefinition& part) const {
  double norm = 0;
  for (const Equation& e : part.equations) norm = std::hypot(norm, rounding_[row_of(e)] / of(e));
  return norm;
}

std::vector<double> Magnitudes::of_unknowns(const PartDefinition& part) const {
  std::vector<double> result;
  for (const int i : part.unknowns) result.push_back(of_coordinate_[i]);
  return result;
}

std::vector<double> Magnitudes::weights(const PartDefinition& part) const {
  std::vector<double> result;
  for (const Equation& e : part.equations) result.push_back(1 / of(e));
  return result;
}

}  // namespace desmo
