#include "formulations/codegen/eliminate/adjugate.h"

#include <stdexcept>

namespace desmo::generate {

namespace {

/// A cofactor, and the sum of its products' absolute values.
struct Cofactor {
  Expr value, magnitude;
};

Cofactor cofactor(const std::vector<std::vector<Expr>>& m, std::size_t row, std::size_t column) {
  if (m.size() == 2) {
    const Expr entry = m[1 - row][1 - column];
    return {row == column ? entry : -entry, abs(entry)};
  }
  // With cyclic indices, a cofactor of a (3 × 3) matrix needs no alternating sign.
  const std::size_t i = (row + 1) % 3, k = (row + 2) % 3, j = (column + 1) % 3,
                    l = (column + 2) % 3;
  const Expr main = m[i][j] * m[k][l], side = m[i][l] * m[k][j];
  return {main - side, abs(main) + abs(side)};
}

}  // namespace

Adjugate::Adjugate(const std::vector<std::vector<Expr>>& m) {
  const std::size_t n = m.size();
  cofactors_.resize(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const auto [value, size] = cofactor(m, i, j);
      cofactors_[i].push_back(value);
      if (i > 0) continue;
      determinant_ = determinant_ + m[0][j] * value;
      magnitude_ = magnitude_ + (n == 2 ? abs(m[0][j] * value) : abs(m[0][j]) * size);
    }
  if (determinant_.is_zero()) throw std::invalid_argument("the Jacobian is structurally singular");
  reciprocal_ = Expr(1) / determinant_;
}

std::vector<Expr> Adjugate::solve(const std::vector<Expr>& b) const {
  std::vector<Expr> x;
  for (std::size_t j = 0; j < b.size(); ++j) {
    Expr sum = 0;
    for (std::size_t i = 0; i < b.size(); ++i) sum = sum + cofactors_[i][j] * b[i];
    x.push_back(sum * reciprocal_);
  }
  return x;
}

}  // namespace desmo::generate
