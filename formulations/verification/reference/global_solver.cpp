#include "formulations/verification/reference/global_solver.h"

#include <Eigen/SparseLU>
#include <algorithm>
#include <boost/multiprecision/eigen.hpp>
#include <cmath>
#include <stdexcept>
#include <string>

#include "cases/mechanism/motion.h"
#include "formulations/model/scales.h"
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
    : m_(m),
      system_(m),
      magnitude_(nominal_magnitudes(m)),
      state_(m.state_size()),
      positions_(m.state_size()),
      phi_(system_.rows()),
      linear_(
          std::make_unique<Linear>(system_.rows(), static_cast<int>(system_.unknowns().size()))) {
  std::ranges::transform(m.estimate, state_.begin(), [](double x) { return Jet<S>(S(x)); });
  for (std::size_t i = 0; i < m.fixed_values.size(); ++i)
    state_[m.coordinates() + i] = Jet<S>(as<S>(m.fixed_value(i)));
}

template <class S>
GlobalSolver<S>::~GlobalSolver() {}  // here, where Linear is complete

template <class S>
void GlobalSolver<S>::drive(std::span<const MotionSample<S>> drivers) {
  for (std::size_t k = 0; k < drivers.size(); ++k) {
    const MotionSample<S>& z = drivers[k];
    state_[m_.entities[m_.drivers[k].coordinate].first] = {z.position, z.velocity, z.acceleration};
  }
}

template <class S>
void GlobalSolver<S>::drive(std::span<const S> drivers) {
  for (std::size_t k = 0; k < drivers.size(); ++k)
    state_[m_.entities[m_.drivers[k].coordinate].first].value = drivers[k];
}

template <class S>
void GlobalSolver<S>::set_homotopy(double share) {
  if (initial_.empty()) {
    std::ranges::transform(state_, positions_.begin(), &Jet<S>::value);
    initial_.resize(phi_.size());
    system_.template residual<S>(positions_, initial_);
  }
  share_ = share;
}

template <class S>
void GlobalSolver<S>::predict(const S& step) {
  for (const int i : system_.unknowns()) {
    Jet<S>& x = state_[i];
    x.value += step * (x.first + step / 2 * x.second);
  }
}

template <class S>
double GlobalSolver<S>::correct_positions() {
  factor();
  system_.template residual<S>(positions_, {linear_->residual.data(), phi_.size()});
  if (share_ != 0)
    for (std::size_t r = 0; r < initial_.size(); ++r)
      linear_->residual[static_cast<Eigen::Index>(r)] -= share_ * initial_[r];
  return correct(&Jet<S>::value);
}

template <class S>
void GlobalSolver<S>::solve_positions(double t) {
  time_ = t;
  std::vector<MotionSample<S>> drivers;
  for (const Driver& d : m_.drivers) drivers.push_back(sample(d.motion, S(t)));
  drive(drivers);
  Settling<S> settled;
  for (int iteration = 0; iteration < 50; ++iteration)
    if (settled(correct_positions())) return;
  throw std::runtime_error(m_.name + ": no global reference solution at t = " + std::to_string(t) +
                           " s");
}

template <class S>
void GlobalSolver<S>::solve_rates() {
  factor();
  for (const int i : system_.unknowns()) state_[i].first = state_[i].second = S(0);
  for (int pass = 0; pass < 3; ++pass) {
    system_.template residual<Jet<S>>(state_, phi_);  // Φ, Φ̇ and Φ̈
    for (const auto order : {&Jet<S>::first, &Jet<S>::second}) {
      std::ranges::transform(phi_, linear_->residual.data(), order);
      correct(order);
    }
  }
}

/// Factorises Φ_φ at the present positions.
template <class S>
void GlobalSolver<S>::factor() {
  auto& [residual, entries, matrix, lu, analysed] = *linear_;
  if (residual.size() == 0) return;  // drivers only
  std::ranges::transform(state_, positions_.begin(), &Jet<S>::value);
  entries.clear();
  system_.template jacobian<S>(positions_, [&](int row, int state, const S& value) {
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

/// Subtracts Φ_φ⁻¹ times the residual from one order of the unknowns. Returns the largest
/// correction relative to the nominal magnitude of its coordinate.
template <class S>
double GlobalSolver<S>::correct(S Jet<S>::*order) {
  if (linear_->residual.size() == 0) return 0;
  const typename Linear::Vector step = linear_->lu.solve(linear_->residual);
  double largest = 0;
  for (Eigen::Index j = 0; j < step.size(); ++j) {
    const int i = system_.unknowns()[j];
    state_[i].*order -= step[j];
    const double relative_step = std::abs(static_cast<double>(step[j])) / magnitude_[i];
    if (!(relative_step <= largest)) largest = relative_step;  // NaN stays
  }
  return largest;
}

template class GlobalSolver<Quadruple>;
// Follows the motion, for which positions are enough.
template GlobalSolver<double>::GlobalSolver(const Model&);
template GlobalSolver<double>::~GlobalSolver();
template void GlobalSolver<double>::drive(std::span<const MotionSample<double>>);
template void GlobalSolver<double>::drive(std::span<const double>);
template void GlobalSolver<double>::set_homotopy(double);
template double GlobalSolver<double>::correct_positions();
template void GlobalSolver<double>::solve_positions(double);

}  // namespace desmo
