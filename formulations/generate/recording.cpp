#include "formulations/generate/recording.h"

#include <algorithm>
#include <cctype>

#include "cases/constraints.h"

namespace desmo::generate {

namespace {

std::string identifier(std::string name) {
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
}

/// Whether an expression depends on a position or rate, as opposed to dimensions alone.
bool depends_on_state(int id, int first_constant_input, int end_constant_input) {
  const Node& n = Graph::current().node(id);
  if (n.op == Op::input) return id < first_constant_input || id >= end_constant_input;
  return (n.a >= 0 && depends_on_state(n.a, first_constant_input, end_constant_input)) ||
         (n.b >= 0 && depends_on_state(n.b, first_constant_input, end_constant_input));
}

}  // namespace

std::string variable_name(const GroupType& type, int input) {
  const std::string name = "_" + identifier(type.inputs[input].name);
  for (int i = 0; i < input; ++i)
    if ("_" + identifier(type.inputs[i].name) == name) return name + "_" + std::to_string(input);
  return name;
}

RecordedGroup record(const GroupType& type, const std::vector<SamplePoint>& samples) {
  Graph& graph = Graph::current();
  RecordedGroup g;
  const std::vector<double> unsampled(samples.size(), 0.0);  // rates: no pivot depends on them
  const int inputs = static_cast<int>(type.inputs.size());
  for (int i = 0; i < inputs; ++i) {
    const std::string name = variable_name(type, i);
    const bool fixed = type.inputs[i].role == Role::fixed;
    std::vector<double> values;
    for (const SamplePoint& s : samples) values.push_back(s.q[i]);
    g.q.push_back(Expr::node(graph.input("q" + name, std::move(values))));
    g.qd.push_back(fixed ? Expr(0) : Expr::node(graph.input("qd" + name, unsampled)));
    g.qdd.push_back(fixed ? Expr(0) : Expr::node(graph.input("qdd" + name, unsampled)));
  }
  std::vector<Expr> constants;
  const int first_constant = graph.size();
  for (std::size_t i = 0; i < type.constants.size(); ++i) {
    std::vector<double> values;
    for (const SamplePoint& s : samples) values.push_back(s.constants[i]);
    constants.push_back(Expr::node(graph.input("c[" + std::to_string(i) + "]", std::move(values))));
  }
  const int end_constant = graph.size();

  g.phi.resize(type.rows);
  g.gamma.resize(type.rows);
  int row = 0;
  for (const GroupType::Equation& equation : type.equations) {
    visit_kind(equation.kind, [&]<class Kind>(Kind) {
      std::array<const Expr*, Kind::operand_sizes.size()> x, v;
      for (std::size_t k = 0; k < x.size(); ++k) {
        x[k] = g.q.data() + equation.operands[k];
        v[k] = g.qd.data() + equation.operands[k];
      }
      const Expr* c = constants.data() + equation.first_constant;
      Kind::residual(x.data(), c, g.phi.data() + row);
      Kind::quadratic(x.data(), v.data(), c, g.gamma.data() + row);
      Kind::jacobian(x.data(), c, [&](int r, int operand, int component, Expr value) {
        const int input = equation.operands[operand] + component;
        const Role role = type.inputs[input].role;
        if (role == Role::fixed) return;
        auto& list = !depends_on_state(value.id(), first_constant, end_constant) ? g.constant
                     : role == Role::unknown                                     ? g.dependent
                                                                                 : g.known;
        list.push_back({row + r, input, value});
      });
      row += Kind::rows;
    });
  }
  return g;
}

}  // namespace desmo::generate
