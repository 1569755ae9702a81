#include "formulations/codegen/emit/explicit_plan.h"

#include <algorithm>

#include "formulations/codegen/emit/emission.h"

namespace desmo::generate {

namespace {

/// What makes a number without unit of what is left of some equations.
Expr weight(const std::vector<int>& rows) {
  Graph& graph = Graph::current();
  const std::vector<double> unsampled(Expr(1).samples().size(), 1.0);
  Expr product = 1;
  for (const int r : rows)
    product = product * Expr::node(graph.input("w[" + std::to_string(r) + "]", unsampled));
  return product;
}

/// The components of an entity stand together.
std::string place(const PartType& type, int input) {
  int first = 0;
  for (const PartType::Constraint& c : type.constraints)
    for (const int o : c.operands)
      if (o <= input) first = std::max(first, o);
  const std::string offset = input > first ? " + " + std::to_string(input - first) : "";
  return "[in[" + std::to_string(first) + "]" + offset + "]";
}

}  // namespace

ExplicitPlan::ExplicitPlan(const PartType& its_type, const RecordedPart& its_part)
    : type(its_type),
      part(its_part),
      order(explicit_order(type, part)),
      motion(differentiate(part, order)) {
  for (const OrderSection& s : order) {
    Expr sum = 0;
    for (std::size_t r = 0; r < s.residuals.size(); ++r) {
      const Expr weighted = weight(s.residual_rows[r]) * s.residuals[r];
      sum = sum + weighted * weighted;
    }
    residual2.push_back(sum);
    for (const Definition& d : s.definitions)
      roots.insert(roots.end(), d.form.roots.begin(), d.form.roots.end());
  }
  for (std::size_t i = 0; i < type.inputs.size(); ++i) {
    const std::string at = place(type, static_cast<int>(i));
    places[part.q[i].id()] = "q" + at;
    places[part.qd[i].id()] = "qd" + at;
    places[part.qdd[i].id()] = "qdd" + at;
  }
}

std::vector<int> ExplicitPlan::torn() const {
  std::vector<int> result;
  for (const OrderSection& s : order) result.insert(result.end(), s.torn.begin(), s.torn.end());
  return result;
}

std::vector<int> ExplicitPlan::angles() const {
  std::vector<int> result;
  for (const OrderSection& s : order)
    for (const Definition& d : s.definitions)
      if (d.form.bearing) result.push_back(d.unknowns.front());
  return result;
}

}  // namespace desmo::generate
