#include "formulations/codegen/record/expansion.h"

#include "formulations/codegen/record/inputs.h"

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
  Quadratic q{{{1, l.rest, r.rest}}, {std::vector<Expr>(l.rest.coefficient.size()), 0}};
  return q;
}

}  // namespace

std::optional<Quadratic> expand(Expr e, const std::vector<Expr>& x) {
  Quadratic q{{}, {std::vector<Expr>(x.size()), 0}};
  if (!reads(e, x)) {
    q.rest.constant = e;
    return q;
  }
  const Node n = Graph::current().node(e.id());
  if (n.op == Op::input) {
    for (std::size_t i = 0; i < x.size(); ++i)
      if (x[i].id() == e.id()) q.rest.coefficient[i] = 1;
    return q;
  }
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
  if (!reads(e, {theta})) return Trigonometric{0, 0, e};
  const Node n = Graph::current().node(e.id());
  if (n.op == Op::input) return std::nullopt;
  if (n.op == Op::cosine || n.op == Op::sine) {
    if (n.a != theta.id()) return std::nullopt;
    return n.op == Op::cosine ? Trigonometric{1, 0, 0} : Trigonometric{0, 1, 0};
  }
  const Expr a = Expr::node(n.a), b = n.b < 0 ? Expr(0) : Expr::node(n.b);
  const std::optional<Trigonometric> l = expand_angle(a, theta), r = expand_angle(b, theta);
  if (!l || !r) return std::nullopt;
  const auto times = [](const Trigonometric& t, Expr by) {
    return Trigonometric{t.cosine * by, t.sine * by, t.rest * by};
  };
  switch (n.op) {
    case Op::add:
      return Trigonometric{l->cosine + r->cosine, l->sine + r->sine, l->rest + r->rest};
    case Op::subtract:
      return Trigonometric{l->cosine - r->cosine, l->sine - r->sine, l->rest - r->rest};
    case Op::negate:
      return times(*l, -1);
    case Op::multiply:
      if (!reads(a, {theta})) return times(*r, a);
      if (!reads(b, {theta})) return times(*l, b);
      return std::nullopt;
    default:
      return std::nullopt;
  }
}

}  // namespace desmo::generate
