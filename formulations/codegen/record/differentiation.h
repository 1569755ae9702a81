#pragma once

#include <map>

#include "formulations/codegen/record/expression.h"

namespace desmo::generate {

/// Returns ∂e/∂input, with all other inputs held constant.
Expr partial(Expr e, Expr input);

/// Time derivatives of expressions by the chain rule, given the rates of their inputs. Rates that
/// were not set are zero.
class Rates {
 public:
  void set_first(Expr input, Expr rate) { first_.insert_or_assign(input.id(), rate); }
  void set_second(Expr input, Expr rate) { second_.insert_or_assign(input.id(), rate); }

  Expr first(Expr e) const;   ///< ė
  Expr second(Expr e) const;  ///< ë

 private:
  std::map<int, Expr> first_, second_;
};

}  // namespace desmo::generate
