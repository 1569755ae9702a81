#include "formulations/codegen/order/angle_separation.h"

#include "formulations/codegen/record/expansion.h"
#include "formulations/codegen/record/inputs.h"

namespace desmo::generate {

std::optional<SeparatedAngle> separate_angle(const Block& block, int angle, const PartType& type,
                                             const RecordedPart& part) {
  const Expr theta = part.q[angle];
  std::vector<Said> with;
  for (const Said& s : block.equations)
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
      -((p->sine * inverse) * p->rest + (q->sine * inverse) * q->rest)};  // (cos θ, sin θ)
  std::vector<int> rows = with[0].rows;
  rows.insert(rows.end(), with[1].rows.begin(), with[1].rows.end());
  Definition definition{angle_by_bearing("angle", bearing, 1), {angle}, {}};
  for (const int r : rows) definition.because.push_back(type.row_names[r]);
  return SeparatedAngle{{p->rest * p->rest + q->rest * q->rest - radius2, rows}, definition};
}

}  // namespace desmo::generate
