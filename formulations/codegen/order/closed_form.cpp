#include "formulations/codegen/order/closed_form.h"

#include <utility>

#include "formulations/codegen/record/expression.h"

namespace desmo::generate {

namespace {

/// Returns the values of a form with one root, with its branch replaced by another one.
std::vector<Expr> values_on(const ClosedForm& form, Expr branch) {
  std::vector<Expr> result;
  for (const Expr v : form.values)
    result.push_back(substitute(v, {{form.roots.front().branch.id(), branch}}));
  return result;
}

bool are_equal(const std::vector<Expr>& a, const std::vector<Expr>& b, double sign) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i].id() != (sign * b[i]).id()) return false;
  return a.size() == b.size();
}

bool has_one_root_and_no_angle(const ClosedForm& form) {
  return form.roots.size() == 1 && !form.bearing;
}

}  // namespace

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
  for (const auto rule : {&solve_linear, &solve_sphere, &solve_direction_and_length, &solve_angle})
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

std::optional<ClosedForm> as_earlier_or_opposite(const ClosedForm& form, const ClosedForm& earlier,
                                                 const std::vector<Expr>& x) {
  if (!has_one_root_and_no_angle(form) || !has_one_root_and_no_angle(earlier) ||
      form.values.size() != earlier.values.size())
    return std::nullopt;
  const Expr branch = form.roots.front().branch, its_branch = earlier.roots.front().branch;
  if (!are_equal(values_on(earlier, -its_branch), earlier.values, -1)) return std::nullopt;
  const std::vector<Expr> on_this = values_on(earlier, branch);
  const bool same = are_equal(form.values, on_this, 1);
  if (!same && !are_equal(form.values, on_this, -1)) return std::nullopt;

  const Expr sign = (same ? 1 : -1) * (branch * its_branch);
  const auto signed_all = [sign](std::vector<Expr> values) {
    for (Expr& v : values) v = sign * v;
    return values;
  };
  ClosedForm result;
  result.rule = form.rule + " again";
  result.values = signed_all(x);
  result.roots = form.roots;
  result.rates = [=](const Rates& rates, Level level) {
    std::vector<Expr> of_x;
    for (const Expr e : x) of_x.push_back(rates.of(level, e));
    return signed_all(of_x);
  };
  return result;
}

}  // namespace desmo::generate
