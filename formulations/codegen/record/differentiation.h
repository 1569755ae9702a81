#pragma once

#include <map>

#include "cases/mechanism/level.h"
#include "formulations/codegen/record/expression.h"

namespace desmo::generate {

/// Returns ∂e/∂input, with all other inputs held constant.
Expr partial(Expr e, Expr input);

/// Time derivatives of expressions by the chain rule, given the rates of their inputs. Rates that
/// were not set are zero.
class Rates {
 public:
  /// Sets the rate of an input at a level: its velocity or its acceleration.
  void set(Level level, Expr input, Expr rate) {
    (level == Level::velocity ? velocities_ : accelerations_).insert_or_assign(input.id(), rate);
  }

  /// Returns the velocity ė or the acceleration ë of an expression.
  Expr of(Level level, Expr e) const;

 private:
  std::map<int, Expr> velocities_, accelerations_;
};

}  // namespace desmo::generate
