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

/// Adds the nodes that an expression contains and that move.
void collect(int id, std::set<int>& seen) {
  const Node& n = Graph::current().node(id);
  if (!n.moves || !seen.insert(id).second) return;
  if (n.a >= 0) collect(n.a, seen);
  if (n.b >= 0) collect(n.b, seen);
}

}  // namespace

std::vector<Expr> moving_inputs(Expr e) {
  std::set<int> seen;
  collect(e.id(), seen);
  std::vector<Expr> result;
  for (const int id : seen)
    if (Graph::current().node(id).op == Op::input) result.push_back(Expr::node(id));
  return result;
}

bool reads(Expr e, const std::vector<Expr>& nodes) {
  std::set<int> seen;
  collect(e.id(), seen);
  return std::ranges::any_of(nodes, [&](Expr node) { return seen.contains(node.id()); });
}

Expr substitute(Expr e, const std::map<int, Expr>& by_input) {
  std::map<int, Expr> done = by_input;
  return replaced(e, done);
}

}  // namespace desmo::generate
