// The basis of errors in exact arithmetic: each corner of the set that it encloses is in its box.

#include "formulations/verification/certificate/error_basis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "formulations/verification/certificate/error_table.h"

namespace desmo::error_basis_test {
namespace {

using Exact = boost::multiprecision::cpp_rational;

/// Solves equations whose right sides come last.
template <std::size_t columns, std::size_t n = columns - 1>
std::array<Exact, n> solve(std::array<std::array<Exact, columns>, n> a) {
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (abs(a[i][k]) > abs(a[pivot][k])) pivot = i;
    std::swap(a[k], a[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const Exact factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j <= n; ++j) a[i][j] -= factor * a[k][j];
    }
  }
  std::array<Exact, n> x;
  for (std::size_t k = 0; k < n; ++k) x[k] = a[k][n] / a[k][k];
  return x;
}

/// Returns the largest symbol that corners of G t have in a basis: 1 where it holds them.
template <std::size_t n>
Exact largest_symbol(const ErrorBasis& basis, const std::vector<std::array<double, n>>& columns) {
  std::array<Exact, n> sums;
  for (const std::array<double, n>& g : columns) {
    std::array<std::array<Exact, n + 1>, n> equations;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t s = 0; s < n; ++s)
        equations[i][s] = Exact(basis.generator(static_cast<int>(i), static_cast<int>(s)));
      equations[i][n] = Exact(g[i]);
    }
    const std::array<Exact, n> symbols = solve(equations);
    for (std::size_t s = 0; s < n; ++s) sums[s] += abs(symbols[s]);
  }
  return *std::ranges::max_element(sums);
}

/// Returns the basis of errors G t and each component's own.
template <std::size_t n>
ErrorBasis basis_of(const std::vector<std::array<double, n>>& columns,
                    const std::array<double, n>& own = {}) {
  const int count = static_cast<int>(columns.size());
  ErrorBasis basis(n, count);
  basis.start(n, count);
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<double> row;
    for (const std::array<double, n>& g : columns) row.push_back(g[i]);
    basis.set(static_cast<int>(i), row.data(), own[i]);
  }
  basis.enclose();
  return basis;
}

/// In directions that are exact, what rounding of Qᵀ G adds to short ones.
TEST(ErrorBasis, CountsRoundingAlongExactDirections) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(0.1, 0.2);
  for (int trial = 0; trial < (DESMO_SANITIZED ? 4 : 40); ++trial) {
    std::vector<std::array<double, 4>> g;
    for (int s = 0; s < 4; ++s) {
      const double size = std::ldexp(0.25, -12 * s);
      const double other = s % 2 == 0 ? size : -size, sign = s < 2 ? 1 : -1;
      g.push_back({size, other, sign * size, sign * other});
    }
    const double x = uniform(generator);
    std::array<double, 4> noisy;
    for (double& component : noisy) component = x * (1 + 0x1p-50 * uniform(generator) * 40);
    g.push_back(noisy);
    EXPECT_LE(largest_symbol(basis_of(g), g), 1);
  }
}

/// Less than half of the last place of 1, which rounding loses.
constexpr double lost = 0x1.fp-54;

TEST(ErrorBasis, CountsRoundingOfManySymbols) {
  std::vector<std::array<double, 1>> g(100, {lost});
  g.front() = {1};
  EXPECT_LE(largest_symbol(basis_of(g), g), 1);
}

TEST(ErrorTable, CountsRoundingOfManySymbols) {
  const std::vector<double> symbols(100, lost);
  ErrorTable::Row row;
  row.set_error(-1, symbols);
  EXPECT_LE(1 + 100 * Exact(lost), Exact(row.sum));
  EXPECT_LE(row.sum, 1 + 1e-13);
  EXPECT_EQ(row.centre, -1);
  EXPECT_EQ(row.own, 0);
}

TEST(ErrorBasis, BoundsWhatItsDirectionsAreOff) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const double off : {0.0, 1e-15, 1e-12, 1e-8})
    for (int trial = 0; trial < (DESMO_SANITIZED ? 5 : 100); ++trial) {
      const double x = uniform(generator), y = std::sqrt((1 - x) * (1 + x));
      std::array<double, 4> q{x, -y, y, x};
      for (double& component : q) component += off * uniform(generator);
      Exact norm = 0;
      for (int s = 0; s < 2; ++s) {
        Exact sum = 0;
        for (int r = 0; r < 2; ++r)
          sum += abs(Exact(q[s]) * Exact(q[r]) + Exact(q[2 + s]) * Exact(q[2 + r]) - (s == r));
        if (sum > norm) norm = sum;
      }
      const double found = ErrorBasis::deviation(q, 2);
      EXPECT_LE(norm, Exact(found)) << off;
      EXPECT_LE(found, 1.01 * static_cast<double>(norm) + 1e-14) << off;
    }
}

TEST(ErrorBasis, HoldsNearlyDependentErrors) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const double apart : {0.5, 1e-2, 1e-4, 1e-6, 1e-9, 1e-13})
    for (int trial = 0; trial < (DESMO_SANITIZED ? 2 : 8); ++trial) {
      // Columns differ little from the first one, in ever smaller ways.
      std::vector<std::array<double, 3>> g(3);
      std::array<double, 3> own;
      for (int i = 0; i < 3; ++i) {
        g[0][i] = uniform(generator);
        g[1][i] = g[0][i] + apart * uniform(generator);
        g[2][i] = g[1][i] + apart * apart * uniform(generator);
        own[i] = trial % 2 == 0 ? 0 : 1e-3 * apart * std::abs(uniform(generator));
      }
      const ErrorBasis basis = basis_of(g, own);
      for (int i = 0; i < 3; ++i) g.emplace_back()[i] = own[i];
      EXPECT_LE(largest_symbol(basis, g), 1) << apart;
      // The box is not much wider than the set.
      for (int i = 0; i < 3; ++i) {
        double sum = 0, enclosed = 0;
        for (const std::array<double, 3>& column : g) sum += std::abs(column[i]);
        for (int s = 0; s < 3; ++s) enclosed += std::abs(basis.generator(i, s));
        EXPECT_LE(enclosed, 3 * sum + 10 * apart);
      }
    }
}

}  // namespace
}  // namespace desmo::error_basis_test
