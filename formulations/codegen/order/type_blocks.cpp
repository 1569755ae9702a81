#include "formulations/codegen/order/type_blocks.h"

#include <map>
#include <stdexcept>
#include <utility>

#include "formulations/codegen/record/expansion.h"
#include "formulations/codegen/record/expression.h"
#include "formulations/model/csparse.h"

namespace desmo::generate {

std::vector<Block> blocks_of(const PartType& type, const RecordedPart& part) {
  const std::vector<int> unknowns = unknowns_of(type);
  const int n = static_cast<int>(unknowns.size());
  std::map<int, int> column;
  for (int j = 0; j < n; ++j) column.emplace(part.q[unknowns[j]].id(), j);
  std::vector<std::pair<int, int>> ones;
  for (int r = 0; r < n; ++r)
    for (const Expr input : moving_inputs(part.phi[r]))
      if (const auto it = column.find(input.id()); it != column.end())
        ones.emplace_back(r, it->second);
  const CSparseForm form = decompose(n, n, ones);
  if (form->rr[4] != form->rr[3] || form->cc[1] != 0)
    throw std::invalid_argument("the equations are structurally singular");
  std::vector<Block> blocks;
  for (const auto& [rows, columns] : blocks_in_order(*form)) {
    Block& block = blocks.emplace_back();
    for (const int j : columns) block.unknowns.push_back(unknowns[j]);
    for (const int r : rows) block.equations.push_back({part.phi[r], {r}});
  }
  return blocks;
}

std::optional<SeparatedAngle> separate_angle(const Block& block, int angle, const PartType& type,
                                             const RecordedPart& part) {
  const Expr theta = part.q[angle];
  std::vector<EquationOfRows> with;
  for (const EquationOfRows& s : block.equations)
    if (reads(s.equation, {theta})) with.push_back(s);
  if (with.size() != 2) return std::nullopt;
  const auto p = expand_angle(with[0].equation, theta), q = expand_angle(with[1].equation, theta);
  if (!p || !q) return std::nullopt;
  const std::vector<Expr> unknowns = positions(part, block.unknowns);
  for (const Expr e : {p->cosine, p->sine, q->cosine, q->sine})
    if (reads(e, unknowns)) return std::nullopt;
  const bool turns = q->cosine.id() == (-p->sine).id() && q->sine.id() == p->cosine.id();
  const bool mirrors = q->cosine.id() == p->sine.id() && q->sine.id() == (-p->cosine).id();
  if (!turns && !mirrors) return std::nullopt;

  const Expr radius2 = p->cosine * p->cosine + p->sine * p->sine, inverse = Expr(1) / radius2;
  const ClosedForm::Bearing bearing{
      -((p->cosine * inverse) * p->rest + (q->cosine * inverse) * q->rest),
      -((p->sine * inverse) * p->rest + (q->sine * inverse) * q->rest)};  // equals (cos θ, sin θ)
  std::vector<int> rows = with[0].rows;
  rows.insert(rows.end(), with[1].rows.begin(), with[1].rows.end());
  Definition definition{angle_by_bearing("angle", bearing, 1), {angle}, {}};
  for (const int r : rows) definition.because.push_back(type.row_names[r]);
  return SeparatedAngle{{p->rest * p->rest + q->rest * q->rest - radius2, rows}, definition};
}

}  // namespace desmo::generate
