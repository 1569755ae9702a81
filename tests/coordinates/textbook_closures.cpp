// What a mechanism condenses to in desmo, in the terms of textbooks.

#include <gtest/gtest.h>

#include <memory>
#include <set>

#include "formulations/algebra/condensation.h"
#include "formulations/equations/automatic.h"
#include "formulations/model/partition.h"
#include "tests/coordinates/textbook_motion.h"

namespace desmo::textbook_test {

namespace {

/// Keeps the matrix and the right-hand side that it is given.
class Keeper final : public LinearSolver {
 public:
  Keeper(const Pattern& p, MatrixXd& a, VectorXd& b) : p_(p), a_(a), b_(b) {}
  bool factor(const double* values) override {
    a_ = MatrixXd::Zero(p_.n, p_.n);
    for (int j = 0; j < p_.n; ++j)
      for (int k = p_.column_start[j]; k < p_.column_start[j + 1]; ++k)
        a_(p_.row[k], j) = values[k];
    return true;
  }
  void solve(double* b) override { b_ = Eigen::Map<VectorXd>(b, p_.n); }

 private:
  const Pattern p_;
  MatrixXd& a_;
  VectorXd& b_;
};

}  // namespace

void Instant::condense() {
  const AutomaticEquations equations(m, part_);
  const Pattern& p = equations.pattern();
  const std::vector<Derivation> derived = derivations(m, part_);
  std::vector<double> values(p.size());
  equations.constant_jacobian(values.data());
  equations.jacobian(q.data(), values.data());
  Condensed condensed(p, derived, [&](const Pattern& pattern) {
    return std::make_unique<Keeper>(pattern, jacobian, gamma);
  });
  EXPECT_TRUE(condensed.factor(values.data()));
  VectorXd all(p.n);
  equations.quadratic(q.data(), qd.data(), all.data());
  condensed.solve(all.data());
  std::set<int> rows;
  for (const Derivation& d : derived) rows.insert(d.row);
  for (int i = 0; i < p.n; ++i)
    if (!rows.contains(i)) closures.push_back(part_.equations[i]);
  for (const int unknown : condensed.reduced_pattern().unknowns)
    column.emplace(unknown, static_cast<int>(column.size()));
  turn_euler_parameters();
}

void Instant::turn_euler_parameters() {
  for (const Entity& e : m.entities) {
    if (e.kind != EntityKind::orientation) continue;
    const Eigen::Map<const Eigen::Vector4d> x(&q[e.first]), v(&qd[e.first]);
    const int first = column.at(e.first);
    const MatrixXd by = jacobian.middleCols(first, 4);
    gamma -= by * x * v.squaredNorm();
    Eigen::Matrix<double, 4, 3> turns;  // δe = ½ Eᵀ δω
    turns << -x[1], -x[2], -x[3], x[0], x[3], -x[2], -x[3], x[0], x[1], x[2], -x[1], x[0];
    jacobian.middleCols(first, 4).setZero();
    jacobian.middleCols(first + 1, 3) = by * turns / 2;
  }
}

}  // namespace desmo::textbook_test
