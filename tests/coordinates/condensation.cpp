// Static condensation against dense elimination, on random sparse systems.

#include "formulations/algebra/condensation.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

namespace desmo::condensation_test {
namespace {

/// A dense solver by Eigen, which remembers the matrix.
class DenseSolver final : public LinearSolver {
 public:
  DenseSolver(const Pattern& pattern, Eigen::MatrixXd& seen) : pattern_(pattern), seen_(seen) {}
  bool factor(const double* values) override {
    seen_ = Eigen::Map<const Eigen::SparseMatrix<double>>(
        pattern_.n, pattern_.n, pattern_.dependent_entries(), pattern_.column_start.data(),
        pattern_.row.data(), values);
    lu_.compute(seen_);
    return true;
  }
  void solve(double* b) override {
    Eigen::Map<Eigen::VectorXd> x(b, pattern_.n);
    x = lu_.solve(x).eval();
  }

 private:
  const Pattern pattern_;
  Eigen::MatrixXd& seen_;
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
};

/// A random system: derivations in random rows and columns, each explicit in its unknown, of
/// unknowns that are not derived or are derived before.
struct System {
  int n;
  std::vector<Derivation> derivations;
  Eigen::MatrixXd a;
  Pattern pattern;
  std::vector<double> values;

  System(int unknowns, int derived, std::mt19937& random) : n(unknowns) {
    const auto number = [&] { return std::uniform_real_distribution(-1.0, 1.0)(random); };
    const auto seldom = [&] { return random() % 4 == 0; };
    std::vector<int> row(n), column(n);
    std::iota(row.begin(), row.end(), 0);
    column = row;
    std::ranges::shuffle(row, random);
    std::ranges::shuffle(column, random);
    a = Eigen::MatrixXd::Zero(n, n);
    for (int d = 0; d < derived; ++d) {
      derivations.push_back({row[d], column[d]});
      for (int k = 0; k < n; ++k)
        if ((k < d || k >= derived) && seldom()) a(row[d], column[k]) = number();
      a(row[d], column[d]) = random() % 2 ? 1 : -1;
    }
    for (int c = derived; c < n; ++c) {
      for (int k = 0; k < n; ++k)
        if (seldom()) a(row[c], column[k]) = number();
      a(row[c], column[c]) += 3;
    }
    pattern.n = n;
    pattern.unknowns.resize(n);
    std::iota(pattern.unknowns.begin(), pattern.unknowns.end(), 0);
    const Eigen::SparseMatrix<double> sparse = a.sparseView();
    const auto entries = sparse.nonZeros();
    pattern.column_start.assign(sparse.outerIndexPtr(), sparse.outerIndexPtr() + n + 1);
    pattern.row.assign(sparse.innerIndexPtr(), sparse.innerIndexPtr() + entries);
    values.assign(sparse.valuePtr(), sparse.valuePtr() + entries);
  }
};

/// Returns C_x − C_y D_y⁻¹ D_x of a system with rows d of derivations and c of closures, and with
/// columns y that are derived and x that are not.
Eigen::MatrixXd schur_complement(const System& s) {
  std::vector<bool> is_derivation(s.n, false), is_derived(s.n, false);
  for (const Derivation& d : s.derivations) is_derivation[d.row] = is_derived[d.column] = true;
  std::vector<int> d, c, y, x;
  for (int i = 0; i < s.n; ++i) {
    (is_derivation[i] ? d : c).push_back(i);
    (is_derived[i] ? y : x).push_back(i);
  }
  return s.a(c, x) - s.a(c, y) * s.a(d, y).partialPivLu().solve(Eigen::MatrixXd(s.a(d, x)));
}

TEST(Condensation, SolvesWhatADenseEliminationSolvesByTheSchurComplement) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const int n = 2 + static_cast<int>(random() % 30), derived = 1 + static_cast<int>(random() % n);
    const System s(n, derived, random);
    Eigen::MatrixXd reduced;
    Condensed condensed(s.pattern, s.derivations, [&](const Pattern& pattern) {
      return std::make_unique<DenseSolver>(pattern, reduced);
    });
    EXPECT_EQ(condensed.reduced_pattern().n, n - derived);
    for (int again = 0; again < 2; ++again) {  // a second factorisation leaves nothing of the first
      ASSERT_TRUE(condensed.factor(s.values.data()));
      const Eigen::VectorXd b = Eigen::VectorXd::Random(n);
      Eigen::VectorXd x = b;
      condensed.solve(x.data());
      EXPECT_LE((s.a * x - b).norm(), 1e-10 * s.a.norm() * std::max(1.0, x.norm())) << trial;
    }
    if (derived == n) continue;  // nothing is left
    const Eigen::MatrixXd expected = schur_complement(s);
    EXPECT_LE((reduced - expected).norm(), 1e-10 * std::max(1.0, expected.norm())) << trial;
  }
}

}  // namespace
}  // namespace desmo::condensation_test
