#include "formulations/codegen/order/core_system.h"

#include <stdexcept>
#include <utility>

namespace desmo::generate {

CoreSystem::CoreSystem(std::vector<std::map<int, Expr>> matrix) {
  if (matrix.size() != 2) {
    elimination_.emplace(std::move(matrix));
    return;
  }
  a_ = matrix[0][0], b_ = matrix[0][1];
  c_ = matrix[1][0], d_ = matrix[1][1];
  const Expr main = a_ * d_, side = b_ * c_, determinant = main - side;
  if (determinant.is_zero()) throw std::invalid_argument("a core is structurally singular");
  inverse_ = Expr(1) / determinant;
  sizes_ = {{abs(determinant), 1e-6, abs(main) + abs(side)}};
}

std::vector<Expr> CoreSystem::solve(const std::vector<Expr>& b) const {
  if (elimination_) return elimination_->solve(b);
  return {(d_ * b[0] - b_ * b[1]) * inverse_, (a_ * b[1] - c_ * b[0]) * inverse_};
}

std::vector<PivotMonitor> CoreSystem::pivots() const {
  return elimination_ ? elimination_->monitors() : std::vector<PivotMonitor>{};
}

}  // namespace desmo::generate
