#pragma once

#include <map>

#include "formulations/codegen/record/expression.h"

namespace desmo::generate {

/// ∂e/∂input, all other inputs held.
Expr partial(Expr e, Expr input);

/// First and second derivatives of expressions along a motion, given those of their inputs; those
/// of inputs not given are zero.
class Rates {
 public:
  void set_first(Expr input, Expr rate) { first_.insert_or_assign(input.id(), rate); }
  void set_second(Expr input, Expr rate) { second_.insert_or_assign(input.id(), rate); }

  Expr first(Expr e) const;
  Expr second(Expr e) const;

 private:
  std::map<int, Expr> first_, second_;
};

}  // namespace desmo::generate
