#pragma once

#include <Eigen/SparseLU>
#include <algorithm>
#include <boost/multiprecision/eigen.hpp>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "cases/motion.h"
#include "formulations/accuracy/jet.h"
#include "formulations/accuracy/scales.h"
#include "formulations/accuracy/settling.h"
#include "formulations/accuracy/whole_system.h"

namespace desmo {

/// Solves all equations of a mechanism at once with a sparse LU factorisation, in the scalar S.
/// Nothing but the residuals decides what is found: velocities and accelerations are those that
/// make the time derivatives of Φ vanish, which jets evaluate. The partial derivatives that the
/// kinds state only lead there, and the partition and the quadratic terms are not used.
template <class S>
class GlobalSolver {
 public:
  /// Starts at the mechanism's estimate. The mechanism must outlive the solver.
  explicit GlobalSolver(const Mechanism& m)
      : m_(m),
        system_(m),
        magnitude_(natural_magnitudes(m)),
        state_(m.state_size()),
        positions_(m.state_size()),
        phi_(system_.rows()),
        residual_(system_.rows()),
        matrix_(system_.rows(), static_cast<int>(system_.unknowns().size())) {
    const auto constant = [](double x) { return Jet<S>(S(x)); };
    std::ranges::transform(m.estimate, state_.begin(), constant);
    std::ranges::transform(m.fixed_values, state_.begin() + m.coordinates(), constant);
  }

  /// Newton starts there next: the positions of another solver.
  template <class T>
  void start_at(const GlobalSolver<T>& other) {
    for (std::size_t i = 0; i < state_.size(); ++i) state_[i].value = S(other.state()[i].value);
  }

  /// As exactly as S allows, from where it is. Throws std::runtime_error, naming the instant, when
  /// Newton's method does not converge or a matrix is singular.
  void solve_positions(double t) {
    time_ = t;
    for (const Driver& d : m_.drivers) {
      const MotionSample<S> z = sample(d.motion, S(t));
      state_[m_.entities[d.coordinate].first] = {z.position, z.velocity, z.acceleration};
    }
    Settling<S> settled;
    for (int iteration = 0; iteration < 50; ++iteration) {
      factorise();
      system_.template residual<S>(positions_, {residual_.data(), phi_.size()});
      if (settled(correct(&Jet<S>::value))) return;
    }
    throw std::runtime_error(m_.name +
                             ": no global reference solution at t = " + std::to_string(t) + " s");
  }

  /// Velocities and accelerations at the positions solved last. The equations are linear in each:
  /// the first pass finds q̇, the second q̈, and each is refined by the next.
  void solve_rates() {
    factorise();
    for (const int i : system_.unknowns()) state_[i].first = state_[i].second = S(0);
    for (int pass = 0; pass < 3; ++pass) {
      system_.template residual<Jet<S>>(state_, phi_);  // Φ, Φ̇ and Φ̈
      for (const auto order : {&Jet<S>::first, &Jet<S>::second}) {
        std::ranges::transform(phi_, residual_.data(), order);
        correct(order);
      }
    }
  }

  /// The instant solved last, in coordinate order.
  std::vector<S> q() const { return coordinates(&Jet<S>::value); }
  std::vector<S> qd() const { return coordinates(&Jet<S>::first); }
  std::vector<S> qdd() const { return coordinates(&Jet<S>::second); }
  const std::vector<Jet<S>>& state() const { return state_; }

 private:
  using Vector = Eigen::Matrix<S, Eigen::Dynamic, 1>;
  using Matrix = Eigen::SparseMatrix<S>;

  /// Φ_φ at the present positions.
  void factorise() {
    if (residual_.size() == 0) return;  // drivers only
    std::ranges::transform(state_, positions_.begin(), &Jet<S>::value);
    entries_.clear();
    system_.template jacobian<S>(positions_, [&](int row, int state, const S& value) {
      const int column = system_.column(state);
      if (column >= 0) entries_.emplace_back(row, column, value);
    });
    matrix_.setFromTriplets(entries_.begin(), entries_.end());
    if (!analysed_) lu_.analyzePattern(matrix_);
    analysed_ = true;
    lu_.factorize(matrix_);
    if (lu_.info() != Eigen::Success)
      throw std::runtime_error(m_.name +
                               ": singular global matrix at t = " + std::to_string(time_) + " s");
  }

  /// Subtracts Φ_φ⁻¹ times the residual from one order of the unknowns. Returns the largest
  /// correction relative to the natural magnitude of its coordinate.
  double correct(S Jet<S>::*order) {
    if (residual_.size() == 0) return 0;
    const Vector step = lu_.solve(residual_);
    double largest = 0;
    for (Eigen::Index j = 0; j < step.size(); ++j) {
      const int i = system_.unknowns()[j];
      state_[i].*order -= step[j];
      const double relative_step = std::abs(static_cast<double>(step[j])) / magnitude_[i];
      if (!(relative_step <= largest)) largest = relative_step;  // NaN stays
    }
    return largest;
  }

  std::vector<S> coordinates(S Jet<S>::*order) const {
    std::vector<S> values(m_.coordinates());
    std::transform(state_.begin(), state_.begin() + m_.coordinates(), values.begin(),
                   [&](const Jet<S>& x) { return x.*order; });
    return values;
  }

  const Mechanism& m_;
  WholeSystem system_;
  std::vector<double> magnitude_;  // of each coordinate
  std::vector<Jet<S>> state_;
  std::vector<S> positions_;
  std::vector<Jet<S>> phi_;
  Vector residual_;  // one order of Φ
  std::vector<Eigen::Triplet<S>> entries_;
  Matrix matrix_;
  Eigen::SparseLU<Matrix> lu_;
  bool analysed_ = false;
  double time_ = 0;  // at hand, for messages, s
};

}  // namespace desmo
