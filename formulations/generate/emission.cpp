#include "formulations/generate/emission.h"

#include <charconv>

namespace desmo::generate {

namespace {

constexpr std::size_t longest_inline = 100;  // characters of an expression used once

void count_uses(int id, std::vector<int>& uses) {
  if (uses[id]++) return;
  const Node& n = Graph::current().node(id);
  if (n.a >= 0) count_uses(n.a, uses);
  if (n.b >= 0) count_uses(n.b, uses);
}

bool is_leaf(int id) {
  const Op op = Graph::current().node(id).op;
  return op == Op::constant || op == Op::input;
}

int precedence(Op op) {
  switch (op) {
    case Op::negate:
      return 0;  // never bare beside another operator
    case Op::add:
    case Op::subtract:
      return 1;
    case Op::multiply:
    case Op::divide:
      return 2;
    default:
      return 4;
  }
}

}  // namespace

std::string literal(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  std::string result(text, end);
  if (result.find_first_of(".en") == std::string::npos) result += ".0";
  return value < 0 ? "(" + result + ")" : result;
}

Emitter::Emitter(std::ostream& out, std::string indent, const std::vector<Expr>& outputs)
    : out_(out), indent_(std::move(indent)), uses_(Graph::current().size(), 0) {
  for (const Expr e : outputs) count_uses(e.id(), uses_);
}

void Emitter::prepare(const std::vector<Expr>& expressions) {
  for (const Expr e : expressions) declare(e.id());
}

void Emitter::declare(int id) {
  if (is_leaf(id) || declared_.contains(id)) return;
  const Node& n = Graph::current().node(id);
  declare(n.a);
  if (n.b >= 0) declare(n.b);
  const std::string expression = text(id);
  if (uses_[id] < 2 && expression.size() <= longest_inline) return;
  out_ << indent_ << "const double t" << id << " = " << expression << ";\n";
  declared_.insert(id);
}

std::string Emitter::text(Expr e) const { return text(e.id()); }

std::string Emitter::text(int id) const {
  const Node& n = Graph::current().node(id);
  if (declared_.contains(id)) return "t" + std::to_string(id);
  // Operands that bind less tightly than `least` are put in parentheses.
  const auto operand = [&](int i, int least) {
    const bool closed = declared_.contains(i) || precedence(Graph::current().node(i).op) >= least;
    return closed ? text(i) : "(" + text(i) + ")";
  };
  switch (n.op) {
    case Op::constant:
      return literal(n.value);
    case Op::input:
      return n.name;
    case Op::add:
      return operand(n.a, 1) + " + " + operand(n.b, 2);
    case Op::subtract:
      return operand(n.a, 1) + " - " + operand(n.b, 2);
    case Op::multiply:
      return operand(n.a, 2) + " * " + operand(n.b, 3);
    case Op::divide:
      return operand(n.a, 2) + " / " + operand(n.b, 3);
    case Op::negate:
      return "-" + operand(n.a, 3);
    case Op::sine:
      return "std::sin(" + text(n.a) + ")";
    case Op::cosine:
      return "std::cos(" + text(n.a) + ")";
  }
  return {};
}

std::vector<int> Emitter::inputs_of(const std::vector<Expr>& expressions) {
  std::vector<int> uses(Graph::current().size(), 0), result;
  for (const Expr e : expressions) count_uses(e.id(), uses);
  for (int id = 0; id < Graph::current().size(); ++id)
    if (uses[id] && Graph::current().node(id).op == Op::input) result.push_back(id);
  return result;
}

}  // namespace desmo::generate
