// The block triangular form of a part's equations.

#include <stdexcept>

#include "formulations/base/index_range.h"
#include "formulations/model/csparse.h"
#include "formulations/model/incidence.h"
#include "formulations/model/partition.h"

namespace desmo {

namespace {

/// Returns the decomposition of the incidence matrix (equations × unknowns), which is 1 where an
/// equation reads an unknown.
CSparseForm incidence_form(const Model& m, const PartDefinition& part) {
  const int equations = static_cast<int>(part.equations.size());
  std::vector<std::pair<int, int>> ones;
  for (int i = 0; i < equations; ++i)
    visit_incidence(m, m.constraints[part.equations[i].constraint], [&](int row, int state) {
      if (row != part.equations[i].row) return;
      if (const int j = position_in(part.unknowns, state); j >= 0) ones.emplace_back(i, j);
    });
  return decompose(equations, static_cast<int>(part.unknowns.size()), ones);
}

}  // namespace

std::vector<PartDefinition> irreducible_blocks(const Model& m, const PartDefinition& part) {
  const int n = static_cast<int>(part.unknowns.size());
  const CSparseForm form = incidence_form(m, part);
  if (static_cast<int>(part.equations.size()) != n || form->rr[4] != form->rr[3] ||
      form->cc[1] != 0) {
    const std::string where = m.name + ", group '" + m.groups[part.groups.front()].name + "': ";
    if (form->cc[1] > 0)
      throw std::invalid_argument(
          where + "no equation is left to determine '" +
          m.entities[entity_of_coordinate(m)[part.unknowns[form->q[0]]]].name + "'");
    throw std::invalid_argument(
        where + "no unknown is left for constraint '" +
        m.constraints[part.equations[form->p[form->rr[3]]].constraint].name + "'");
  }

  std::vector<PartDefinition> blocks;
  for (const auto& [rows, columns] : blocks_in_order(*form)) {
    PartDefinition& block = blocks.emplace_back();
    block.groups = part.groups;
    block.constant = part.constant;
    for (const int j : columns) block.unknowns.push_back(part.unknowns[j]);
    for (const int i : rows) block.equations.push_back(part.equations[i]);
  }
  return blocks;
}

}  // namespace desmo
