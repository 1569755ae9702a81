// The block triangular form of a part's equations.

#include <algorithm>
#include <stdexcept>

#include "formulations/structure/csparse.h"
#include "formulations/structure/incidence.h"
#include "formulations/structure/partition.h"

namespace desmo {

namespace {

/// Position of a coordinate among the ascending unknowns, or -1.
int column_of(const std::vector<int>& unknowns, int coordinate) {
  const auto it = std::ranges::lower_bound(unknowns, coordinate);
  return it != unknowns.end() && *it == coordinate ? static_cast<int>(it - unknowns.begin()) : -1;
}

/// Returns the incidence matrix (equations × unknowns): one where an equation reads an unknown.
CSparseMatrix incidence_matrix(const Model& m, const PartDefinition& part) {
  const int n = static_cast<int>(part.unknowns.size());
  const int equations = static_cast<int>(part.equations.size());
  CSparseMatrix triplets(cs_di_spalloc(equations, n, 4 * n, 1, 1));
  for (int i = 0; i < equations;) {
    const int c = part.equations[i].constraint;
    int end = i;
    while (end < equations && part.equations[end].constraint == c) ++end;
    visit_incidence(m, m.constraints[c], [&](int row, int state) {
      const int j = state < m.coordinates() ? column_of(part.unknowns, state) : -1;
      const auto equation =
          std::find(part.equations.begin() + i, part.equations.begin() + end, Equation{c, row});
      if (j >= 0 && equation != part.equations.begin() + end)
        cs_di_entry(triplets.get(), static_cast<int>(equation - part.equations.begin()), j, 1);
    });
    i = end;
  }
  return triplets;
}

}  // namespace

std::vector<PartDefinition> irreducible_blocks(const Model& m, const PartDefinition& part) {
  const int n = static_cast<int>(part.unknowns.size());
  const CSparseForm form = decompose(incidence_matrix(m, part));
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

  // The form is upper triangular: the last block depends on no other.
  std::vector<PartDefinition> blocks;
  for (int b = form->nb - 1; b >= 0; --b) {
    PartDefinition block{part.groups, {}, {}, part.constant};
    for (int j = form->s[b]; j < form->s[b + 1]; ++j)
      block.unknowns.push_back(part.unknowns[form->q[j]]);
    for (int i = form->r[b]; i < form->r[b + 1]; ++i)
      block.equations.push_back(part.equations[form->p[i]]);
    std::ranges::sort(block.unknowns);
    std::ranges::sort(block.equations, {}, [](const Equation& e) {
      return std::pair{e.constraint, e.row};
    });
    blocks.push_back(std::move(block));
  }
  return blocks;
}

}  // namespace desmo
