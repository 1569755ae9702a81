#include "formulations/codegen/emit/emission.h"

#include <charconv>
#include <cmath>
#include <stdexcept>

namespace desmo::generate {

namespace {

constexpr std::size_t max_inline = 100;  // length of an expression without a variable [characters]

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
      return 0;  // always in parentheses next to another operator
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
  if (!std::isfinite(value))
    throw std::invalid_argument("an equation has a constant that is not finite");
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  std::string result(text, end);
  if (result.find_first_of(".en") == std::string::npos) result += ".0";
  return value < 0 ? "(" + result + ")" : result;
}

Emitter::Emitter(std::ostream& out, std::string indent, const std::vector<Expr>& outputs,
                 EmissionStyle style)
    : out_(&out),
      indent_(std::move(indent)),
      style_(std::move(style)),
      uses_(Graph::current().size(), 0) {
  for (const Expr e : outputs) count_uses(e.id(), uses_);
}

void Emitter::write_to(std::ostream& out, std::string indent, bool declarations_apart) {
  out_ = &out;
  indent_ = std::move(indent);
  declarations_apart_ = declarations_apart;
  if (declarations_apart) names_apart_.clear();
}

void Emitter::prepare(const std::vector<Expr>& expressions) {
  for (const Expr e : expressions) declare(e.id());
}

void Emitter::assign(const std::string& variable, const std::string& value, int known) {
  arrival_.define(variable, known);
  if (declarations_apart_) names_apart_.push_back(variable);
  *out_ << indent_ << (declarations_apart_ ? "" : "const " + style_.type + " ") << variable << " = "
        << value << ";\n";
}

void Emitter::define(const std::string& variable, Expr e) {
  prepare({e});
  assign(variable, text(e), known(e));
}

void Emitter::name(Expr e, std::string text) { names_[e.id()] = std::move(text); }

void Emitter::declare(int id) {
  if (is_leaf(id) || names_.contains(id)) return;
  const Node& n = Graph::current().node(id);
  if (style_.folds_dimensions && !n.moves) {
    names_[id] = "f[" + std::to_string(folded_.size()) + "]";
    folded_.push_back(Expr::node(id));
    return;
  }
  declare(n.a);
  if (n.b >= 0) declare(n.b);
  const std::string expression = text(id);
  if (uses_[id] < 2 && expression.size() <= max_inline) return;
  const std::string variable = "t" + std::to_string(id);
  assign(variable, expression, known(Expr::node(id)));
  names_[id] = variable;
}

/// Returns a sum, its terms ordered by arrival: a − b · c + d.
std::string Emitter::sum(int id) const {
  std::string result;
  for (const auto& [term, subtracted] : terms_of(id, arrival_, has_name())) {
    if (!result.empty()) result += subtracted ? " - " : " + ";
    result += result.empty() && subtracted ? "-" + operand(term, 3) : operand(term, 2);
  }
  return result;
}

/// Returns a product, its factors ordered by arrival.
std::string Emitter::product(int id) const {
  std::string result;
  for (const int factor : factors_of(id, arrival_, has_name()))
    result += result.empty() ? operand(factor, 2) : " * " + operand(factor, 3);
  return result;
}

/// Returns an operand's text, in parentheses if it begins with a minus or its operator has a
/// precedence below `least`.
std::string Emitter::operand(int id, int least) const {
  const std::string result = text(id);
  const bool closed = names_.contains(id) ||
                      (precedence(Graph::current().node(id).op) >= least && result.front() != '-');
  return closed ? result : "(" + result + ")";
}

std::string Emitter::text(Expr e) const { return text(e.id()); }

std::string Emitter::text(int id) const {
  const Node& n = Graph::current().node(id);
  if (const auto it = names_.find(id); it != names_.end()) return it->second;
  switch (n.op) {
    case Op::constant:
      return literal(n.value);
    case Op::input:
      return n.name;
    case Op::add:
    case Op::subtract:
    case Op::negate:
      return sum(id);
    case Op::multiply:
      return product(id);
    case Op::divide:
      return operand(n.a, 2) + " / " + operand(n.b, 3);
    case Op::sine:
      return style_.angles + "sin(" + text(n.a) + ")";
    case Op::cosine:
      return style_.angles + "cos(" + text(n.a) + ")";
    case Op::square_root:
      return style_.functions + "sqrt(" + text(n.a) + ")";
    case Op::magnitude:
      return style_.functions + "abs(" + text(n.a) + ")";
    default:
      return "table_coefficient<" + std::to_string(table_order(n.op)) + ", " + style_.type + ">(&" +
             text(n.b) + ", " + text(n.a) + ")";
  }
}

std::map<int, std::string> places_of(const RecordedPart& part,
                                     const std::function<std::string(int input)>& place) {
  std::map<int, std::string> places;
  for (std::size_t i = 0; i < part.q.size(); ++i) {
    const std::string at = place(static_cast<int>(i));
    places[part.q[i].id()] = "q" + at;
    places[part.qd[i].id()] = "qd" + at;
    places[part.qdd[i].id()] = "qdd" + at;
  }
  return places;
}

void declare_inputs(std::ostream& out, const std::vector<Expr>& expressions,
                    const std::string& declaration, const std::map<int, std::string>& places,
                    std::set<int>& declared) {
  std::vector<int> uses(Graph::current().size(), 0);
  for (const Expr e : expressions) count_uses(e.id(), uses);
  for (const auto& [id, place] : places)
    if (uses[id] && Graph::current().node(id).op == Op::input && declared.insert(id).second)
      out << "  " << declaration << " " << Graph::current().node(id).name << " = " << place
          << ";\n";
}

}  // namespace desmo::generate
