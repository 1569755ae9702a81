#include "formulations/codegen/order/closed_form.h"

#include <utility>

namespace desmo::generate {

void Facts::learn(Expr e) {
  const Node n = Graph::current().node(e.id());
  if (e.is_constant()) return;
  known_.insert_or_assign(e.id(), Expr(0));
  if (n.op == Op::subtract && !Expr::node(n.b).moves())
    known_.insert_or_assign(n.a, Expr::node(n.b));
}

void Facts::learn(Expr e, Expr value) { known_.insert_or_assign(e.id(), value); }

Expr Facts::value(Expr e) const {
  const auto it = known_.find(e.id());
  return it == known_.end() ? e : it->second;
}

std::optional<ClosedForm> solve_closed(const Task& task) {
  for (const Rule rule : {&solve_linear, &solve_sphere, &solve_direction_and_length, &solve_angle})
    if (std::optional<ClosedForm> form = rule(task)) return form;
  return std::nullopt;
}

void rates_by_equations(ClosedForm& form, std::vector<Expr> equations,
                        std::function<std::vector<Expr>(const std::vector<Expr>&)> solve) {
  form.rates = [=](const Rates& rates, Level level) {
    std::vector<Expr> b;
    for (const Expr e : equations) b.push_back(-rates.of(level, e));
    return solve(b);
  };
}

ClosedForm angle_by_bearing(std::string rule, ClosedForm::Bearing bearing, Expr radius2) {
  const auto [x, y] = bearing;
  const Expr inverse = Expr(1) / radius2;
  ClosedForm form;
  form.rule = std::move(rule);
  form.bearing = bearing;
  form.cost = 4;
  form.rates = [=](const Rates& r, Level level) {
    const Expr y1 = r.of(Level::velocity, y), x1 = r.of(Level::velocity, x);
    const Expr rate = (x * y1 - y * x1) * inverse;
    if (level == Level::velocity) return std::vector<Expr>{rate};
    const Expr changes =
        x * r.of(level, y) - y * r.of(level, x) - rate * r.of(Level::velocity, radius2);
    return std::vector<Expr>{changes * inverse};
  };
  return form;
}

Expr branch_of(Expr pivot) {
  std::vector<double> signs;
  for (const double p : pivot.samples()) signs.push_back(p < 0 ? -1 : 1);
  return Expr::node(Graph::current().input("branch", std::move(signs)));
}

Expr magnitude(Expr e) {
  const Node n = Graph::current().node(e.id());
  if (n.op == Op::add || n.op == Op::subtract)
    return magnitude(Expr::node(n.a)) + magnitude(Expr::node(n.b));
  if (n.op == Op::multiply && n.a == n.b && Graph::current().node(n.a).op == Op::input) return e;
  if (n.op == Op::multiply) return magnitude(Expr::node(n.a)) * magnitude(Expr::node(n.b));
  if (n.op == Op::negate) return magnitude(Expr::node(n.a));
  return abs(e);
}

}  // namespace desmo::generate
