#include "formulations/parts/exact_frames.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace desmo {

ExactFrames::ExactFrames(const Model& m, const PartDefinition& part,
                         std::span<const Derivation> derived, const MakeEquations& make_equations)
    : residual_(part.equations.size()) {
  constexpr std::size_t closure = -1;  // level of equations and unknowns that are not derived
  std::vector<std::size_t> row_level(part.equations.size(), closure),
      column_level(part.unknowns.size(), closure);
  // first level that may read each entity: the one after the level that derives it
  std::vector<std::size_t> first_level(m.entities.size(), 0);
  std::size_t levels = 0;
  for (const auto& [row, column] : derived) {
    const Constraint& c = m.constraints[part.equations[row].constraint];
    std::size_t level = 0;
    for (const EntityId e : c.operands)
      if (e != derived_entity(c)) level = std::max(level, first_level[e]);
    row_level[row] = column_level[column] = level;
    first_level[derived_entity(c)] = level + 1;
    levels = std::max(levels, level + 1);
  }

  std::vector<PartDefinition> definitions(levels + 1);  // of the levels, then of the closures
  for (std::size_t i = 0; i < row_level.size(); ++i) {
    definitions[std::min(row_level[i], levels)].equations.push_back(part.equations[i]);
    definitions[std::min(column_level[i], levels)].unknowns.push_back(part.unknowns[i]);
    if (row_level[i] == closure) closure_row_.push_back(static_cast<int>(i));
  }
  closures_ = make_equations(definitions.back());
  definitions.pop_back();
  for (const PartDefinition& level : definitions)
    levels_.push_back(make_level(m, make_equations(level)));
}

ExactFrames::Level ExactFrames::make_level(const Model& m,
                                           std::unique_ptr<const Equations> equations) {
  // Derivations of a level do not read each other: their Jacobian is a permuted diagonal matrix.
  const Pattern& pattern = equations->pattern();
  std::vector<double> values(pattern.size());
  equations->constant_jacobian(values.data());
  equations->jacobian(m.state_of(m.estimate).data(), values.data());
  Level level;
  for (int j = 0; j < pattern.n; ++j)
    level.derived.push_back({pattern.unknowns[j], pattern.row[j], 1 / values[j]});
  level.equations = std::move(equations);
  return level;
}

void ExactFrames::residual(const Equations&, double* q, Eigen::VectorXd& phi) {
  double zero = 0;  // 0; NaN where a derived unknown is not finite
  for (const Level& level : levels_) {
    level.equations->residual(q, residual_.data());
    for (const auto& [place, row, inverse] : level.derived) {
      q[place] -= inverse * residual_[row];
      zero += q[place] - q[place];
    }
  }
  closures_->residual(q, residual_.data());
  phi.setConstant(zero);
  for (std::size_t c = 0; c < closure_row_.size(); ++c) phi[closure_row_[c]] = residual_[c];
}

}  // namespace desmo
