#include "formulations/accuracy/condition.h"

#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "formulations/accuracy/scales.h"
#include "formulations/accuracy/whole_system.h"

namespace desmo {

struct ConditionNumber::Matrices {
  const Mechanism& m;
  WholeSystem system;
  std::vector<double> magnitude, state;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::SparseMatrix<double> a;
  Eigen::SparseLU<Eigen::SparseMatrix<double>> lu;

  explicit Matrices(const Mechanism& mechanism)
      : m(mechanism),
        system(m),
        magnitude(natural_magnitudes(m)),
        state(m.state_size()),
        a(system.rows(), static_cast<int>(system.unknowns().size())) {
    std::ranges::copy(m.fixed_values, state.begin() + m.coordinates());
  }

  /// a = R⁻¹ Φ_φ S
  void assemble(std::span<const double> q) {
    std::ranges::copy(q, state.begin());
    std::vector<double> sums(system.rows(), 0);
    entries.clear();
    system.jacobian<double>(state, [&](int row, int i, double value) {
      const int column = system.column(i);
      if (column < 0) return;
      entries.emplace_back(row, column, value * magnitude[i]);
      sums[row] += std::abs(value * magnitude[i]);
    });
    for (auto& e : entries)
      if (sums[e.row()] > 0) e = {e.row(), e.col(), e.value() / sums[e.row()]};
    a.setFromTriplets(entries.begin(), entries.end());
  }
};

ConditionNumber::ConditionNumber(const Mechanism& m) : matrices_(std::make_unique<Matrices>(m)) {}
ConditionNumber::~ConditionNumber() = default;

double ConditionNumber::operator()(std::span<const double> q) {
  matrices_->assemble(q);
  const auto n = matrices_->a.rows();
  if (n == 0) return 1;
  auto& lu = matrices_->lu;
  lu.compute(matrices_->a);
  if (lu.info() != Eigen::Success) return INFINITY;
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(n, n);
  const Eigen::MatrixXd inverse = lu.solve(identity);
  const double norm = inverse.cwiseAbs().rowwise().sum().maxCoeff();
  return std::isfinite(norm) ? norm : INFINITY;
}

}  // namespace desmo
