#include "formulations/codegen/record/expansion.h"

#include <algorithm>

#include "formulations/codegen/record/expression.h"

namespace desmo::generate {

namespace {

void scale(Affine& a, Expr by) {
  for (Expr& c : a.coefficient) c = by * c;
  a.constant = by * a.constant;
}

Quadratic scaled(Quadratic q, Expr by) {
  for (Quadratic::Product& p : q.products) p.scale = by * p.scale;
  scale(q.rest, by);
  return q;
}

Quadratic sum(Quadratic l, const Quadratic& r) {
  l.products.insert(l.products.end(), r.products.begin(), r.products.end());
  for (std::size_t i = 0; i < l.rest.coefficient.size(); ++i)
    l.rest.coefficient[i] = l.rest.coefficient[i] + r.rest.coefficient[i];
  l.rest.constant = l.rest.constant + r.rest.constant;
  return l;
}

std::optional<Quadratic> product(const Quadratic& l, const Quadratic& r) {
  if (!l.products.empty() || !r.products.empty()) return std::nullopt;
  return Quadratic{{{1, l.rest, r.rest}}, {std::vector<Expr>(l.rest.coefficient.size()), 0}};
}

}  // namespace

std::optional<Quadratic> expand(Expr e, const std::vector<Expr>& x) {
  Quadratic q{{}, {std::vector<Expr>(x.size()), 0}};
  if (!reads(e, x)) {
    q.rest.constant = e;
    return q;
  }
  if (const auto at = std::ranges::find(x, e.id(), &Expr::id); at != x.end()) {
    q.rest.coefficient[at - x.begin()] = 1;
    return q;
  }
  const Node n = Graph::current().node(e.id());
  const Expr a = Expr::node(n.a), b = n.b < 0 ? Expr(0) : Expr::node(n.b);
  const std::optional<Quadratic> l = expand(a, x), r = expand(b, x);
  if (!l || !r) return std::nullopt;
  switch (n.op) {
    case Op::add:
      return sum(*l, *r);
    case Op::subtract:
      return sum(*l, scaled(*r, -1));
    case Op::negate:
      return scaled(*l, -1);
    case Op::multiply:
      if (!reads(a, x)) return scaled(*r, a);
      if (!reads(b, x)) return scaled(*l, b);
      return product(*l, *r);
    case Op::divide:
      if (!reads(b, x)) return scaled(*l, Expr(1) / b);
      return std::nullopt;
    default:
      return std::nullopt;
  }
}

std::optional<Trigonometric> expand_angle(Expr e, Expr theta) {
  const std::optional<Quadratic> q = expand(e, {cos(theta), sin(theta)});
  if (!q || !q->products.empty()) return std::nullopt;
  const auto& [coefficient, rest] = q->rest;
  for (const Expr part : {coefficient[0], coefficient[1], rest})
    if (reads(part, {theta})) return std::nullopt;
  return Trigonometric{coefficient[0], coefficient[1], rest};
}

}  // namespace desmo::generate
