#include "formulations/model/locking.h"

#include <algorithm>
#include <array>

#include "formulations/constraints/constraints.h"

namespace desmo {

namespace {

/// Returns whether the slopes of an equation by unknowns stay the same when these change.
bool is_linear_in(const std::vector<int>& unknowns, const Model& m, const Equation& equation) {
  const Constraint& c = m.constraints[equation.constraint];
  // Returns the place of an operand's component among the unknowns, from 1; 0: it is none.
  const auto place = [&](std::size_t operand, int component) {
    const Entity& e = m.entities[c.operands[operand]];
    const auto found = std::ranges::find(unknowns, e.fixed ? no_position : e.first + component);
    return found == unknowns.end() ? 0 : found - unknowns.begin() + 1;
  };
  const auto slopes = [&](double change) {
    std::vector<double> result;
    visit_kind(c.kind, [&]<class Kind>(Kind) {
      std::array<std::array<double, max_components>, Kind::operand_sizes.size()> values{};
      std::array<const double*, Kind::operand_sizes.size()> x;
      for (std::size_t k = 0; k < x.size(); ++k) {
        const Entity& e = m.entities[c.operands[k]];
        for (int i = 0; i < e.size; ++i)
          values[k][i] =
              (e.fixed ? m.fixed_values : m.estimate)[e.first + i] + change * place(k, i);
        x[k] = values[k].data();
      }
      Kind::jacobian(x.data(), constants_at<Kind>(c.constants.data(), x.data()).data(),
                     [&](int row, int operand, int component, double value) {
                       if (row == equation.row && place(operand, component) > 0)
                         result.push_back(value);
                     });
    });
    return result;
  };
  return slopes(0) == slopes(1);
}

}  // namespace

bool may_lock(const Model& m, const PartDefinition& block, const std::vector<EntityId>& owner) {
  const auto is_geometric = [&](int coordinate) {
    const EntityKind kind = m.entities[owner[coordinate]].kind;
    return kind == EntityKind::point || kind == EntityKind::vector;
  };
  const bool is_single = m.groups[block.groups.front()].bodies.size() == 1;
  const auto is_linear = [&](const Equation& e) {
    if (is_single) return is_linear_in(block.unknowns, m, e);
    bool linear = false;
    visit_kind(m.constraints[e.constraint].kind, [&](auto kind) { linear = kind.linear; });
    return linear;
  };
  return std::ranges::any_of(block.unknowns, is_geometric) &&
         !std::ranges::all_of(block.equations, is_linear);
}

}  // namespace desmo
