#include "formulations/codegen/emit/inlined_solve.h"

#include <map>
#include <string>
#include <vector>

#include "formulations/codegen/emit/emission.h"
#include "formulations/codegen/emit/monitors.h"

namespace desmo::generate {

namespace {

using Expressions = std::vector<Expr>;

Expressions concatenate(std::initializer_list<Expressions> lists) {
  Expressions all;
  for (const Expressions& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

std::string name_of(const char* function, std::size_t order) {
  return order == 0 ? function : function + ("_in_order_" + std::to_string(order + 1));
}

}  // namespace

InlinedSolve::InlinedSolve(const PartType& type, const RecordedPart& part, std::size_t max_orders,
                           std::size_t first_samples)
    : type_(type),
      part_(part),
      unknowns_(unknowns_of(type)),
      orders_(eliminations(jacobian_rows(), max_orders, first_samples)) {}

void InlinedSolve::write(std::ostream& out) const {
  FunctionWriter function(out, part_);
  for (std::size_t order = orders_.size(); order-- > 0;) {
    write_position(out, function, order);
    write_rates(out, function, order);
  }
}

void InlinedSolve::write_position(std::ostream& out, FunctionWriter& function,
                                  std::size_t order) const {
  const Expressions step = orders_[order].solve(part_.phi);
  const std::vector<double> unsampled(Graph::current().samples(part_.phi.front().id()).size(), 1.0);
  Expr norm2 = 0;
  for (int r = 0; r < type_.rows(); ++r) {
    const std::string name = "weight[" + std::to_string(r) + "]";
    const Expr weighted = Expr::node(Graph::current().input(name, unsampled)) * part_.phi[r];
    norm2 = norm2 + weighted * weighted;
  }
  const Expressions all = concatenate({{norm2}, step});

  function.open("InlinedResult " + name_of("position", order) +
                "(double* q, const int* in, const double* c, const double* weight,\n"
                "                       double tolerance2, int max_iterations)");
  function.load(positions(part_, unknowns_), "double");
  function.load(all);
  out << "  InlinedResult result{0, 0};\n  for (;; ++result.iterations) {\n";
  Emitter emitter(out, "    ", all);
  emitter.prepare({norm2});
  out << "    result.residual2 = " << emitter.text(norm2) << ";\n"
      << "    if (!(result.residual2 >= tolerance2) || result.iterations == max_iterations) "
         "break;\n";
  emitter.prepare(step);
  // All increments before any update: later ones may be written with the old values.
  for (std::size_t j = 0; j < step.size(); ++j)
    out << "    const double delta" << j << " = " << emitter.text(step[j]) << ";\n";
  for (std::size_t j = 0; j < step.size(); ++j)
    out << "    q" << variable_name(type_, unknowns_[j]) << " -= delta" << j << ";\n";
  out << "  }\n";
  if (!is_last(order))
    out << "  if (!(result.residual2 < tolerance2) && tolerance2 > 0) {\n"
        << "    InlinedResult other = " << name_of("position", order + 1)
        << "(q, in, c, weight, tolerance2, max_iterations);\n"
        << "    other.iterations += result.iterations;\n    return other;\n  }\n";
  for (std::size_t j = 0; j < step.size(); ++j)
    out << "  q[in[" << unknowns_[j] << "]] = q" << variable_name(type_, unknowns_[j]) << ";\n";
  out << "  return result;\n";
  function.close();
}

void InlinedSolve::write_rates(std::ostream& out, FunctionWriter& function,
                               std::size_t order) const {
  const Elimination& elimination = orders_[order];
  const Monitors monitors{{}, elimination.monitors()};
  // Velocities of the unknowns become expressions of the known, and enter γ as such.
  const Expressions velocity = elimination.solve(known_product(part_.qd));
  const Expressions watched = monitored(monitors);
  Expressions acceleration_right = known_product(part_.qdd);
  for (int r = 0; r < type_.rows(); ++r)
    acceleration_right[r] = acceleration_right[r] - part_.gamma[r];
  const Expressions acceleration = elimination.solve(acceleration_right);

  function.open("bool " + name_of("rates", order) +
                "(const double* q, double* qd, double* qdd, const int* in, const double* c)");
  const Expressions first = concatenate({watched, velocity});
  function.load(first);
  Emitter emitter(out, "  ", concatenate({watched, velocity, acceleration}));
  emitter.prepare(first);
  out << "  if (!(" << all_of(conditions(emitter, monitors)) << ")) return "
      << (is_last(order) ? "false" : name_of("rates", order + 1) + "(q, qd, qdd, in, c)") << ";\n";
  for (std::size_t j = 0; j < velocity.size(); ++j) {
    const std::string name = "qd" + variable_name(type_, unknowns_[j]);
    out << "  const double " << name << " = " << emitter.text(velocity[j]) << ";\n"
        << "  qd[in[" << unknowns_[j] << "]] = " << name << ";\n";
  }
  for (const int i : unknowns_) function.take_for_declared(part_.qd[i]);
  out << "  if (!qdd) return true;\n";
  function.load(acceleration);
  emitter.prepare(acceleration);
  for (std::size_t j = 0; j < acceleration.size(); ++j)
    out << "  qdd[in[" << unknowns_[j] << "]] = " << emitter.text(acceleration[j]) << ";\n";
  out << "  return true;\n";
  function.close();
}

SparseRows InlinedSolve::jacobian_rows() const {
  std::map<int, int> column;
  for (const int i : unknowns_) column.emplace(i, static_cast<int>(column.size()));
  SparseRows result(type_.rows());
  for (const auto* list : {&part_.constant, &part_.dependent})
    for (const RecordedEntry& e : *list)
      if (const auto it = column.find(e.input); it != column.end() && !e.value.is_zero())
        result[e.row].emplace(it->second, e.value);
  return result;
}

/// −Φ_h w for the rates w of the known inputs.
Expressions InlinedSolve::known_product(const Expressions& rate) const {
  Expressions result(type_.rows(), Expr(0));
  for (const auto* list : {&part_.constant, &part_.known})
    for (const RecordedEntry& e : *list)
      if (type_.inputs[e.input].role == Role::known)
        result[e.row] = result[e.row] - e.value * rate[e.input];
  return result;
}

}  // namespace desmo::generate
