#include "tests/properties/assembled_drawing.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "formulations/model/scales.h"
#include "formulations/parts/groupwise/dense_lu.h"
#include "formulations/verification/reference/whole_system.h"
#include "formulations/verification/reference/wide_instant.h"

namespace desmo::properties {

namespace {

using Values = std::vector<Quadruple>;

constexpr double max_first_correction = 0.01;  // of a step, over natural magnitudes
constexpr double solved = 1e-28;               // correction, likewise, that only rounding leaves
constexpr double min_step = 1e-6;              // of λ

class Homotopy {
 public:
  explicit Homotopy(const Model& m)
      : system_(m),
        magnitude_(natural_magnitudes(m)),
        state_(m.estimate.begin(), m.estimate.end()) {
    for (std::size_t i = 0; i < m.fixed_values.size(); ++i)
      state_.push_back(as<Quadruple>(m.fixed_value(i)));
    drawn_ = residual();
  }

  /// Goes from λ = 0 to 1. Returns whether it could.
  bool follow() {
    Quadruple lambda = 0, step = Quadruple(1) / 16;
    while (lambda < 1 && step > min_step) {
      const Quadruple next = std::min(Quadruple(1), Quadruple(lambda + step));
      const Values before = state_;
      if (solve(next)) {
        lambda = next;
        step *= 2;
      } else {
        state_ = before;
        step /= 2;
      }
    }
    return lambda == 1;
  }
  const Values& state() const { return state_; }

 private:
  Values residual() const {
    Values phi(system_.rows());
    system_.residual<Quadruple>(state_, phi);
    return phi;
  }

  /// Solves Φ(q) = (1 − λ) Φ(drawing) by Newton's method, which has to contract at once.
  bool solve(const Quadruple& lambda) {
    double last = INFINITY;
    for (int i = 0; i < 30; ++i) {
      const double correction = correct(lambda);
      if (correction < solved) return true;
      if (!(correction < (i == 0 ? max_first_correction : last / 2))) return last < 1e-20;
      last = correction;
    }
    return last < 1e-20;
  }

  double correct(const Quadruple& lambda) {
    const std::size_t n = system_.unknowns().size();
    Values matrix(n * n), right = residual();
    for (std::size_t i = 0; i < right.size(); ++i) right[i] = (1 - lambda) * drawn_[i] - right[i];
    system_.jacobian<Quadruple>(state_, [&](int row, int component, const Quadruple& value) {
      if (system_.column(component) >= 0) matrix[row * n + system_.column(component)] += value;
    });
    const Values change = DenseLu(std::move(matrix), n).solve(std::move(right));
    double largest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const int k = system_.unknowns()[i];
      state_[k] += change[i];
      const double size = std::abs(static_cast<double>(change[i])) / magnitude_[k];
      if (!(size <= largest)) largest = size;  // NaN stays
    }
    return largest;
  }

  const WholeSystem system_;
  const std::vector<double> magnitude_;
  Values state_, drawn_;
};

}  // namespace

Model with_assembled_drawing(Model m) {
  Homotopy homotopy(m);
  if (!homotopy.follow()) throw std::runtime_error(m.name + ": the drawing means no position");
  for (int i = 0; i < m.coordinates(); ++i)
    m.estimate[i] = static_cast<double>(homotopy.state()[i]);
  return m;
}

}  // namespace desmo::properties
