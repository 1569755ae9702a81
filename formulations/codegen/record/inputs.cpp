#include "formulations/codegen/record/inputs.h"

#include <algorithm>
#include <set>

namespace desmo::generate {

namespace {

Expr replaced(Expr e, std::map<int, Expr>& done) {
  if (const auto it = done.find(e.id()); it != done.end()) return it->second;
  const Node n = Graph::current().node(e.id());
  if (n.op == Op::constant || n.op == Op::input) return e;
  const int a = replaced(Expr::node(n.a), done).id();
  const int b = n.b < 0 ? -1 : replaced(Expr::node(n.b), done).id();
  Graph& graph = Graph::current();
  const Expr result = Expr::node(b < 0 ? graph.unary(n.op, a) : graph.binary(n.op, a, b));
  return done.emplace(e.id(), result).first->second;
}

void collect(int id, std::set<int>& seen, std::set<int>& inputs) {
  const Node& n = Graph::current().node(id);
  if (!n.moves || !seen.insert(id).second) return;
  if (n.op == Op::input) inputs.insert(id);
  if (n.a >= 0) collect(n.a, seen, inputs);
  if (n.b >= 0) collect(n.b, seen, inputs);
}

}  // namespace

std::vector<Expr> moving_inputs(Expr e) {
  std::set<int> seen, inputs;
  collect(e.id(), seen, inputs);
  std::vector<Expr> result;
  for (const int id : inputs) result.push_back(Expr::node(id));
  return result;
}

bool reads(Expr e, const std::vector<Expr>& inputs) {
  return std::ranges::any_of(moving_inputs(e), [&](Expr i) {
    return std::ranges::find(inputs, i.id(), &Expr::id) != inputs.end();
  });
}

Expr substitute(Expr e, const std::map<int, Expr>& by_input) {
  std::map<int, Expr> done = by_input;
  return replaced(e, done);
}

}  // namespace desmo::generate
