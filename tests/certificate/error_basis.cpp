// The basis of errors in exact arithmetic: each corner of the set that it encloses is in its box.

#include "formulations/verification/certificate/error_basis.h"

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <random>

namespace desmo::error_basis_test {
namespace {

using Exact = boost::multiprecision::cpp_rational;
constexpr int size = 3, columns = 3;
using Row = std::array<Exact, size + 1>;

/// Solves three equations, whose right sides come last.
std::array<Exact, size> solve(std::array<Row, size> a) {
  for (int k = 0; k < size; ++k) {
    int pivot = k;
    for (int i = k + 1; i < size; ++i)
      if (abs(a[i][k]) > abs(a[pivot][k])) pivot = i;
    std::swap(a[k], a[pivot]);
    for (int i = 0; i < size; ++i) {
      if (i == k) continue;
      const Exact factor = a[i][k] / a[k][k];
      for (int j = k; j <= size; ++j) a[i][j] -= factor * a[k][j];
    }
  }
  std::array<Exact, size> x;
  for (int k = 0; k < size; ++k) x[k] = a[k][size] / a[k][k];
  return x;
}

TEST(ErrorBasis, HoldsNearlyDependentErrors) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const double apart : {0.5, 1e-2, 1e-4, 1e-6, 1e-9, 1e-13})
    for (int trial = 0; trial < 8; ++trial) {
      // Columns differ little from the first one, in ever smaller ways.
      std::array<std::array<double, columns>, size> g;
      std::array<double, size> own;
      for (int i = 0; i < size; ++i) {
        g[i][0] = uniform(generator);
        g[i][1] = g[i][0] + apart * uniform(generator);
        g[i][2] = g[i][1] + apart * apart * uniform(generator);
        own[i] = trial % 2 == 0 ? 0 : 1e-3 * apart * std::abs(uniform(generator));
      }
      ErrorBasis basis(size, columns);
      basis.start(size, columns);
      for (int i = 0; i < size; ++i) basis.set(i, g[i].data(), own[i], 0);
      basis.enclose();
      for (int corner = 0; corner < 1 << (columns + size); ++corner) {
        const auto sign = [&](int k) { return Exact((corner >> k & 1) ? 1 : -1); };
        std::array<Row, size> equations;
        for (int i = 0; i < size; ++i) {
          for (int s = 0; s < size; ++s) equations[i][s] = Exact(basis.generator(i, s));
          equations[i][size] = sign(columns + i) * Exact(own[i]);
          for (int k = 0; k < columns; ++k) equations[i][size] += sign(k) * Exact(g[i][k]);
        }
        for (const Exact& t : solve(equations)) EXPECT_LE(abs(t), 1) << apart;
      }
      // The box is not much wider than the set.
      for (int i = 0; i < size; ++i) {
        double sum = own[i], enclosed = 0;
        for (int k = 0; k < columns; ++k) sum += std::abs(g[i][k]);
        for (int s = 0; s < size; ++s) enclosed += std::abs(basis.generator(i, s));
        EXPECT_LE(enclosed, 3 * sum + 10 * apart);
      }
    }
}

}  // namespace
}  // namespace desmo::error_basis_test
