#include "formulations/codegen/order/type_blocks.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "formulations/codegen/record/inputs.h"
#include "formulations/structure/csparse.h"

namespace desmo::generate {

std::vector<Block> blocks_of(const PartType& type, const RecordedPart& part) {
  std::vector<int> unknowns;
  std::map<int, int> column;
  for (std::size_t i = 0; i < type.inputs.size(); ++i)
    if (type.inputs[i].role == Role::unknown) {
      column.emplace(part.q[i].id(), static_cast<int>(unknowns.size()));
      unknowns.push_back(static_cast<int>(i));
    }
  const int n = static_cast<int>(unknowns.size());
  const CSparseMatrix triplets(cs_di_spalloc(n, n, 4 * n, 1, 1));
  for (int r = 0; r < n; ++r)
    for (const Expr input : moving_inputs(part.phi[r]))
      if (const auto it = column.find(input.id()); it != column.end())
        cs_di_entry(triplets.get(), r, it->second, 1);
  const CSparseForm form = decompose(triplets);
  if (form->rr[4] != form->rr[3] || form->cc[1] != 0)
    throw std::invalid_argument("the equations are structurally singular");
  std::vector<Block> blocks;
  for (int b = form->nb - 1; b >= 0; --b) {  // upper triangular: the last depends on no other
    Block block;
    for (int j = form->s[b]; j < form->s[b + 1]; ++j)
      block.unknowns.push_back(unknowns[form->q[j]]);
    std::vector<int> rows(form->p + form->r[b], form->p + form->r[b + 1]);
    std::ranges::sort(block.unknowns);
    std::ranges::sort(rows);
    for (const int r : rows) block.equations.push_back({part.phi[r], {r}});
    blocks.push_back(std::move(block));
  }
  return blocks;
}

}  // namespace desmo::generate
