#include "formulations/verification/reference/global_solver.h"

#include <Eigen/SparseLU>
#include <algorithm>
#include <boost/multiprecision/eigen.hpp>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "formulations/constraints/jet.h"
#include "formulations/parts/groupwise/settling.h"
#include "formulations/verification/reference/wide_instant.h"

namespace desmo {

template <class S>
struct GlobalSolver<S>::Linear {
  using Vector = Eigen::Matrix<S, Eigen::Dynamic, 1>;
  using Matrix = Eigen::SparseMatrix<S>;

  Linear(int rows, int columns) : residual(rows), matrix(rows, columns) {}

  Vector residual;  // one order of Φ
  std::vector<Eigen::Triplet<S>> entries;
  Matrix matrix;
  Eigen::SparseLU<Matrix> lu;
  bool analysed = false;
};

template <class S>
GlobalSolver<S>::GlobalSolver(const Model& m)
    : ReferenceSolver<S>(m),
      system_(m),
      linear_(
          std::make_unique<Linear>(system_.rows(), static_cast<int>(system_.unknowns().size()))) {}

template <class S>
GlobalSolver<S>::~GlobalSolver() {}  // here, where Linear is complete

template <class S>
void GlobalSolver<S>::set_homotopy(double share) {
  if (initial_.empty()) {
    initial_.resize(system_.rows());
    system_.template residual<S>(state_.q, initial_);
  }
  share_ = share;
}

template <class S>
double GlobalSolver<S>::correct_positions() {
  factor();
  typename Linear::Vector& residual = linear_->residual;
  system_.template residual<S>(state_.q,
                               {residual.data(), static_cast<std::size_t>(residual.size())});
  if (share_ != 0)
    for (std::size_t r = 0; r < initial_.size(); ++r)
      residual[static_cast<Eigen::Index>(r)] -= share_ * initial_[r];
  return correct(state_.q);
}

template <class S>
void GlobalSolver<S>::solve_positions(double t) {
  time_ = t;
  this->drive_to(t);
  Settling<S> settled;
  for (int iteration = 0; iteration < settled.max_corrections; ++iteration)
    if (settled(correct_positions())) return;
  throw std::runtime_error(m_.name + ": no global reference solution at t = " + std::to_string(t) +
                           " s");
}

template <class S>
void GlobalSolver<S>::solve_rates() {
  factor();
  for (const int i : system_.unknowns()) state_.qd[i] = state_.qdd[i] = S(0);
  std::vector<Jet<S>> state(state_.q.size()), phi(system_.rows());
  for (int pass = 0; pass < 3; ++pass) {
    for (std::size_t i = 0; i < state.size(); ++i)
      state[i] = {state_.q[i], state_.qd[i], state_.qdd[i]};
    system_.template residual<Jet<S>>(state, phi);  // Φ, Φ̇ and Φ̈
    std::ranges::transform(phi, linear_->residual.data(), &Jet<S>::first);
    correct(state_.qd);
    std::ranges::transform(phi, linear_->residual.data(), &Jet<S>::second);
    correct(state_.qdd);
  }
}

/// Factorises Φ_φ at the present positions.
template <class S>
void GlobalSolver<S>::factor() {
  auto& [residual, entries, matrix, lu, analysed] = *linear_;
  if (residual.size() == 0) return;  // drivers only
  entries.clear();
  system_.template jacobian<S>(state_.q, [&](int row, int state, const S& value) {
    const int column = system_.column(state);
    if (column >= 0) linear_->entries.emplace_back(row, column, value);
  });
  matrix.setFromTriplets(entries.begin(), entries.end());
  if (!analysed) lu.analyzePattern(matrix);
  analysed = true;
  lu.factorize(matrix);
  if (lu.info() != Eigen::Success)
    throw std::runtime_error(m_.name + ": singular global matrix at t = " + std::to_string(time_) +
                             " s");
}

/// Subtracts Φ_φ⁻¹ times the residual from the unknowns' positions, or from one of their rates.
/// Returns the largest correction relative to the nominal magnitude of its coordinate.
template <class S>
double GlobalSolver<S>::correct(std::vector<S>& values) {
  if (linear_->residual.size() == 0) return 0;
  const typename Linear::Vector step = linear_->lu.solve(linear_->residual);
  return this->subtract({step.data(), system_.unknowns().size()}, system_.unknowns(), values);
}

template class GlobalSolver<Quadruple>;
// Follows the motion, for which positions are enough.
template GlobalSolver<double>::GlobalSolver(const Model&);
template GlobalSolver<double>::~GlobalSolver();
template void GlobalSolver<double>::set_homotopy(double);
template double GlobalSolver<double>::correct_positions();
template void GlobalSolver<double>::solve_positions(double);

}  // namespace desmo
