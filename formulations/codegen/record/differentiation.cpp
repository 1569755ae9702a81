#include "formulations/codegen/record/differentiation.h"

#include <stdexcept>

namespace desmo::generate {

namespace {

// An expression e of inputs xᵢ has the rates ė = Σ ∂e/∂xᵢ ẋᵢ and
// ë = Σ ∂e/∂xᵢ ẍᵢ + Σ Σ ∂²e/∂xᵢ∂xⱼ ẋᵢ ẋⱼ. Both classes below compute each node once.

/// The sum Σ ∂e/∂xᵢ dᵢ for given expressions dᵢ of the inputs; those that are absent are zero.
class Linear {
 public:
  explicit Linear(const std::map<int, Expr>& of_input) : of_input_(of_input) {}

  Expr operator()(Expr e) {
    if (const auto it = done_.find(e.id()); it != done_.end()) return it->second;
    return done_.emplace(e.id(), compute(e)).first->second;
  }

 private:
  Expr compute(Expr e) {
    const Node n = Graph::current().node(e.id());  // a copy, since the graph grows meanwhile
    if (!n.moves) return 0;
    if (n.op == Op::input) {
      const auto it = of_input_.find(e.id());
      return it == of_input_.end() ? Expr(0) : it->second;
    }
    Linear& d = *this;
    const Expr a = Expr::node(n.a), b = Expr::node(n.b < 0 ? n.a : n.b);
    switch (n.op) {
      case Op::add:
        return d(a) + d(b);
      case Op::subtract:
        return d(a) - d(b);
      case Op::negate:
        return -d(a);
      case Op::multiply:
        return n.a == n.b ? 2 * (a * d(a)) : d(a) * b + a * d(b);
      case Op::divide:
        return (d(a) - e * d(b)) / b;
      case Op::sine:
        return cos(a) * d(a);
      case Op::cosine:
        return -(sin(a) * d(a));
      default:
        if (const int k = table_order(n.op); k >= 0)
          return (k + 1) * (Expr::table_at(k + 1, b, a) * d(a));
        throw std::logic_error("an equation contains what has no derivative");
    }
  }

  const std::map<int, Expr>& of_input_;
  std::map<int, Expr> done_;
};

/// Half of the double sum in ë. The factor 2 is multiplied once, after all sums.
class QuadraticTerm {
 public:
  explicit QuadraticTerm(const std::map<int, Expr>& first_of_input) : first_(first_of_input) {}

  Expr operator()(Expr e) {
    if (const auto it = done_.find(e.id()); it != done_.end()) return it->second;
    return done_.emplace(e.id(), compute(e)).first->second;
  }

 private:
  Expr compute(Expr e) {
    const Node n = Graph::current().node(e.id());
    if (!n.moves || n.op == Op::input) return 0;
    QuadraticTerm& h = *this;
    const Expr a = Expr::node(n.a), b = Expr::node(n.b < 0 ? n.a : n.b);
    switch (n.op) {
      case Op::add:
        return h(a) + h(b);
      case Op::subtract:
        return h(a) - h(b);
      case Op::negate:
        return -h(a);
      case Op::multiply:
        return n.a == n.b ? first_(a) * first_(a) + 2 * (a * h(a))
                          : h(a) * b + first_(a) * first_(b) + a * h(b);
      case Op::divide:
        return (h(a) - first_(e) * first_(b) - e * h(b)) / b;
      case Op::sine:
        return cos(a) * h(a) - 0.5 * (e * (first_(a) * first_(a)));
      case Op::cosine:
        return -(sin(a) * h(a)) - 0.5 * (e * (first_(a) * first_(a)));
      default:
        if (const int k = table_order(n.op); k >= 0)
          return (k + 1) * (Expr::table_at(k + 1, b, a) * h(a)) +
                 0.5 * (k + 1) * (k + 2) * (Expr::table_at(k + 2, b, a) * (first_(a) * first_(a)));
        throw std::logic_error("an equation contains what has no derivative");
    }
  }

  Linear first_;
  std::map<int, Expr> done_;
};

}  // namespace

Expr partial(Expr e, Expr input) {
  Rates rates;
  rates.set(Level::velocity, input, 1);
  return rates.of(Level::velocity, e);
}

Expr Rates::of(Level level, Expr e) const {
  if (level == Level::velocity) return Linear(velocities_)(e);
  return Linear(accelerations_)(e) + 2 * QuadraticTerm(velocities_)(e);
}

}  // namespace desmo::generate
