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

std::string variable_name(const PartType& type, int input) {
  const std::string name = "_" + identifier(type.inputs[input].name);
  for (int i = 0; i < input; ++i)
    if ("_" + identifier(type.inputs[i].name) == name) return name + "_" + std::to_string(input);
  return name;
}

RecordedPart record(const PartType& type, const std::vector<SamplePoint>& samples) {
  Graph& graph = Graph::current();
  RecordedPart g;
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

  for (const PartType::Constraint& constraint : type.constraints) {
    visit_kind(constraint.kind, [&]<class Kind>(Kind) {
      std::array<const Expr*, Kind::operand_sizes.size()> x, v;
      for (std::size_t k = 0; k < x.size(); ++k) {
        x[k] = g.q.data() + constraint.operands[k];
        v[k] = g.qd.data() + constraint.operands[k];
      }
      const Expr* c = constants.data() + constraint.first_constant;
      std::array<Expr, Kind::rows> phi, gamma;
      Kind::residual(x.data(), c, phi.data());
      Kind::quadratic(x.data(), v.data(), c, gamma.data());
      std::array<int, Kind::rows> row;
      row.fill(-1);
      for (const int r : constraint.rows) {
        row[r] = static_cast<int>(g.phi.size());
        g.phi.push_back(phi[r]);
        g.gamma.push_back(gamma[r]);
      }
      Kind::jacobian(x.data(), c, [&](int r, int operand, int component, Expr value) {
        const int input = constraint.operands[operand] + component;
        const Role role = type.inputs[input].role;
        if (role == Role::fixed || row[r] < 0) return;
        auto& list = !depends_on_state(value.id(), first_constant, end_constant) ? g.constant
                     : role == Role::unknown                                     ? g.dependent
                                                                                 : g.known;
        list.push_back({row[r], input, value});
      });
    });
  }
  return g;
}

}  // namespace desmo::generate
