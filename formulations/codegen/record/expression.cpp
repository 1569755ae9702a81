#include "formulations/codegen/record/expression.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "formulations/constraints/table.h"

namespace desmo::generate {

namespace {

/// Returns an expression with its nodes replaced that are in `done`. Adds all that it replaces.
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

/// Adds to `seen` the nodes that an expression contains and that move.
void collect(int id, std::set<int>& seen) {
  const Node& n = Graph::current().node(id);
  if (!n.moves || !seen.insert(id).second) return;
  if (n.a >= 0) collect(n.a, seen);
  if (n.b >= 0) collect(n.b, seen);
}

thread_local Graph* current_graph = nullptr;

double apply(Op op, double a, double b) {
  switch (op) {
    case Op::add:
      return a + b;
    case Op::subtract:
      return a - b;
    case Op::multiply:
      return a * b;
    case Op::divide:
      return a / b;
    case Op::negate:
      return -a;
    case Op::sine:
      return std::sin(a);
    case Op::cosine:
      return std::cos(a);
    case Op::square_root:
      return std::sqrt(a);
    case Op::magnitude:
      return std::abs(a);
    default:
      throw std::logic_error("not an operation");
  }
}

/// Returns whether |value| is a power of two. Multiplication by it is exact, except for underflow
/// and overflow.
bool is_power_of_two(double value) {
  int exponent;
  return std::abs(std::frexp(value, &exponent)) == 0.5;
}

}  // namespace

Graph::Graph(int samples) : sample_count_(samples) {
  if (current_graph) throw std::logic_error("a thread has one graph at a time");
  current_graph = this;
}

Graph::~Graph() { current_graph = nullptr; }

Graph& Graph::current() { return *current_graph; }

int Graph::add(Node node, std::vector<double> sample_values) {
  nodes_.push_back(std::move(node));
  samples_.push_back(std::move(sample_values));
  return size() - 1;
}

int Graph::input(std::string name, std::vector<double> sample_values, bool moves) {
  return add({Op::input, -1, -1, 0, std::move(name), moves}, std::move(sample_values));
}

int Graph::constant(double value) {
  // NaN is no key of a map: it would find any other constant.
  if (std::isnan(value)) throw std::invalid_argument("an equation has a constant that is NaN");
  if (value == 0) value = 0;  // −0 becomes 0
  const auto it = constants_.find(value);
  if (it != constants_.end()) return it->second;
  return constants_[value] = add({Op::constant, -1, -1, value, {}, false},
                                 std::vector<double>(sample_count_, value));
}

bool Graph::is(int id, double value) const {
  return nodes_[id].op == Op::constant && nodes_[id].value == value;
}

int Graph::find_or_add(Op op, int a, int b) {
  const auto it = operations_.find({op, a, b});
  if (it != operations_.end()) return it->second;
  std::vector<double> values(sample_count_);
  for (int s = 0; s < sample_count_; ++s)
    values[s] = table_order(op) >= 0 ? table_value(op, a, b, s)
                                     : apply(op, samples_[a][s], b < 0 ? 0 : samples_[b][s]);
  const bool moves = nodes_[a].moves || (b >= 0 && nodes_[b].moves);
  return operations_[{op, a, b}] = add({op, a, b, 0, {}, moves}, std::move(values));
}

double Graph::table_value(Op op, int a, int table, int sample) const {
  const auto number = [&](int k) { return samples_[table + k][sample]; };
  const double x = samples_[a][sample];
  switch (table_order(op)) {
    case 0:
      return table_number<0>(number, x);
    case 1:
      return table_number<1>(number, x);
    case 2:
      return table_number<2>(number, x);
    default:
      return table_number<3>(number, x);
  }
}

Graph::Scaled Graph::as_scaled(int id) const {
  const Node& n = nodes_[id];
  if (n.op != Op::multiply) return {-1, id};
  if (nodes_[n.a].op == Op::constant) return {n.a, n.b};
  if (nodes_[n.b].op == Op::constant) return {n.b, n.a};
  return {-1, id};
}

double Graph::factor(int id) const {
  if (nodes_[id].op == Op::negate) return factor(nodes_[id].a);
  const int factor = as_scaled(id).factor;
  return factor < 0 ? 1 : nodes_[factor].value;
}

bool Graph::is_reciprocal(int id, int of) const {
  const Node& n = nodes_[id];
  return n.op == Op::divide && is(n.a, 1) && n.b == of;
}

int Graph::unary(Op op, int a) {
  const Node n = nodes_[a];
  if (n.op == Op::constant) return constant(apply(op, n.value, 0));
  if (op == Op::negate && n.op == Op::negate) return n.a;
  if (op == Op::magnitude && n.op == Op::negate) return unary(op, n.a);
  return find_or_add(op, a, -1);
}

int Graph::binary(Op op, int a, int b) {
  const Node l = nodes_[a], r = nodes_[b];
  if (l.op == Op::constant && r.op == Op::constant) return constant(apply(op, l.value, r.value));
  const bool left_negated = l.op == Op::negate, right_negated = r.op == Op::negate;
  const Scaled scaled_l = as_scaled(a), scaled_r = as_scaled(b);
  const bool common = scaled_l.factor >= 0 && scaled_l.factor == scaled_r.factor;
  switch (op) {
    case Op::add:
      if (is(a, 0)) return b;
      if (is(b, 0)) return a;
      if (right_negated) return binary(Op::subtract, a, r.a);
      if (left_negated) return binary(Op::subtract, b, l.a);
      if (common)
        return binary(Op::multiply, scaled_l.factor, binary(Op::add, scaled_l.of, scaled_r.of));
      break;
    case Op::subtract:
      if (is(b, 0)) return a;
      if (is(a, 0)) return unary(Op::negate, b);
      if (a == b) return constant(0);
      if (right_negated) return binary(Op::add, a, r.a);
      if (left_negated) return unary(Op::negate, binary(Op::add, l.a, b));
      if (common)
        return binary(Op::multiply, scaled_l.factor,
                      binary(Op::subtract, scaled_l.of, scaled_r.of));
      if (const auto opposite = operations_.find({op, b, a}); opposite != operations_.end())
        return unary(Op::negate, opposite->second);
      break;
    case Op::multiply:
      if (is(a, 0) || is(b, 0)) return constant(0);
      if (is(a, 1)) return b;
      if (is(b, 1)) return a;
      if (is(a, -1)) return unary(Op::negate, b);
      if (is(b, -1)) return unary(Op::negate, a);
      if (is_reciprocal(a, b) || is_reciprocal(b, a)) return constant(1);
      if (left_negated) return unary(Op::negate, binary(Op::multiply, l.a, b));
      if (right_negated) return unary(Op::negate, binary(Op::multiply, a, r.a));
      if (l.op == Op::constant && scaled_r.factor >= 0 && is_power_of_two(l.value))
        return binary(Op::multiply, binary(Op::multiply, a, scaled_r.factor), scaled_r.of);
      if (r.op == Op::constant && scaled_l.factor >= 0 && is_power_of_two(r.value))
        return binary(Op::multiply, binary(Op::multiply, b, scaled_l.factor), scaled_l.of);
      break;
    case Op::divide:
      if (is(a, 0)) return constant(0);
      if (is(b, 1)) return a;
      if (is(b, -1)) return unary(Op::negate, a);
      if (left_negated) return unary(Op::negate, binary(Op::divide, l.a, b));
      if (right_negated) return unary(Op::negate, binary(Op::divide, a, r.a));
      if (r.op == Op::constant && is_power_of_two(r.value))
        return binary(Op::multiply, a, constant(1 / r.value));
      break;
    default:
      break;
  }
  if ((op == Op::add || op == Op::multiply) && a > b) std::swap(a, b);
  return find_or_add(op, a, b);
}

Expr weight_input(std::string name) {
  Graph& graph = Graph::current();
  return Expr::node(graph.input(std::move(name), std::vector<double>(graph.sample_count(), 1.0)));
}

void append(std::vector<Expr>& all, const std::vector<Expr>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

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
