#include "formulations/codegen/record/recording.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <utility>

#include "formulations/constraints/constraints.h"

namespace desmo::generate {

static_assert(EquationScalar<Expr>);

namespace {

std::string identifier(std::string name) {
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
}

}  // namespace

std::string variable_name(const PartType& type, int input) {
  const std::string name = "_" + identifier(type.inputs[input].name);
  for (int i = 0; i < input; ++i)
    if ("_" + identifier(type.inputs[i].name) == name) return name + "_" + std::to_string(input);
  return name;
}

std::vector<int> unknowns_of(const PartType& type) {
  std::vector<int> result;
  for (std::size_t i = 0; i < type.inputs.size(); ++i)
    if (type.inputs[i].role == Role::unknown) result.push_back(static_cast<int>(i));
  return result;
}

std::vector<Expr> positions(const RecordedPart& part, const std::vector<int>& inputs) {
  std::vector<Expr> result;
  for (const int i : inputs) result.push_back(part.q[i]);
  return result;
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
  std::vector<bool> in_table(type.constants.size());
  for (const PartType::Constraint& c : type.constraints)
    if (const int table = description_of(c.kind).table; table >= 0) {
      const int first = c.first_constant + table;
      std::fill_n(in_table.begin() + first, table_size(static_cast<int>(type.constants[first])),
                  true);
    }
  std::vector<Expr> constants;
  for (std::size_t i = 0; i < type.constants.size(); ++i) {
    std::vector<double> values;
    for (const SamplePoint& s : samples) values.push_back(s.constants[i]);
    // All parts of a type have the same zero dimensions (see PartType).
    constants.push_back(
        type.constants[i] == 0 && !in_table[i]
            ? Expr(0)
            : Expr::node(graph.input("c[" + std::to_string(i) + "]", std::move(values), false)));
  }

  for (const PartType::Constraint& constraint : type.constraints) {
    visit_kind(constraint.kind, [&]<class Kind>(Kind) {
      std::array<const Expr*, Kind::operand_sizes.size()> x, v;
      for (std::size_t k = 0; k < x.size(); ++k) {
        x[k] = g.q.data() + constraint.operands[k];
        v[k] = g.qd.data() + constraint.operands[k];
      }
      const auto about = constants_at<Kind>(constants.data() + constraint.first_constant, x.data());
      const Expr* const c = about.data();
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
        auto& list = !value.moves() ? g.constant : role == Role::unknown ? g.dependent : g.known;
        list.push_back({row[r], input, value});
      });
    });
  }
  return g;
}

SampledType& add_part(const Model& m, const PartDefinition& part,
                      std::span<const std::vector<double>> states,
                      std::vector<SampledType>& found) {
  constexpr std::size_t pivot_samples = 12;  // number of them that is aimed at
  const std::size_t stride = std::max<std::size_t>(1, (states.size() + 3) / pivot_samples);
  PartType type = describe_type(m, part);
  std::vector<SamplePoint> samples;
  for (const std::vector<double>& state : states) {
    SamplePoint& sample = samples.emplace_back();
    for (const PartType::Input& input : type.inputs) sample.q.push_back(state[input.state]);
    sample.constants = type.constants;
  }
  auto it = std::ranges::find(found, type.fingerprint,
                              [](const SampledType& t) { return t.type.fingerprint; });
  if (it == found.end()) it = found.insert(it, {"", std::move(type), {}, {}, false});
  for (std::size_t i = 0; i < samples.size(); i += stride) it->pivot_samples.push_back(samples[i]);
  std::ranges::move(samples, std::back_inserter(it->samples));
  return *it;
}

PartType without_names(PartType type) {
  for (std::size_t i = 0; i < type.inputs.size(); ++i) {
    PartType::Input& input = type.inputs[i];
    input.name = "ukf"[static_cast<int>(input.role)] + std::to_string(i);
  }
  std::size_t row = 0;
  for (std::size_t i = 0; i < type.constraints.size(); ++i) {
    const std::string name =
        std::string(constraint_kind_name(type.constraints[i].kind)) + "#" + std::to_string(i);
    for (std::size_t k = 0; k < type.constraints[i].rows.size(); ++k) type.row_names[row++] = name;
  }
  return type;
}

}  // namespace desmo::generate
