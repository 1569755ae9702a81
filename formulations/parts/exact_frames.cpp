#include "formulations/parts/exact_frames.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace desmo {

namespace {

/// Returns the derivations of a part level by level. One stands a level after the last that it
/// reads.
std::vector<PartDefinition> by_level(const Model& m, const PartDefinition& part,
                                     std::span<const Derivation> derivations) {
  std::vector<PartDefinition> levels;
  // first level that may read each entity
  std::vector<std::size_t> first_level(m.entities.size(), 0);
  for (const auto& [row, column] : derivations) {
    const Equation& equation = part.equations[row];
    const Constraint& c = m.constraints[equation.constraint];
    const EntityId derived = derived_entity(c);
    std::size_t level = 0;
    for (const EntityId e : c.operands)
      if (e != derived) level = std::max(level, first_level[e]);
    first_level[derived] = level + 1;
    levels.resize(std::max(levels.size(), level + 1));
    levels[level].unknowns.push_back(part.unknowns[column]);
    levels[level].equations.push_back(equation);
  }
  for (PartDefinition& level : levels) {
    std::ranges::sort(level.unknowns);
    std::ranges::sort(level.equations);
  }
  return levels;
}

}  // namespace

ExactFrames::ExactFrames(const Model& m, const PartDefinition& part,
                         std::span<const Derivation> derived, const MakeEquations& make_equations)
    : residual_(part.equations.size()) {
  for (const PartDefinition& level : by_level(m, part, derived))
    levels_.push_back(make_level(m, make_equations(level)));

  std::vector<bool> is_derivation(part.equations.size()), is_derived(part.unknowns.size());
  for (const auto& [row, column] : derived) is_derivation[row] = is_derived[column] = true;
  PartDefinition closures;
  for (std::size_t i = 0; i < part.equations.size(); ++i) {
    if (!is_derived[i]) closures.unknowns.push_back(part.unknowns[i]);
    if (is_derivation[i]) continue;
    closures.equations.push_back(part.equations[i]);
    closure_row_.push_back(static_cast<int>(i));
  }
  closures_ = make_equations(closures);
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
