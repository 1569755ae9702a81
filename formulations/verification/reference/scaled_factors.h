#pragma once

#include <memory>
#include <span>
#include <vector>

#include "formulations/verification/reference/whole_system.h"

namespace desmo {

/// Sparse LU factors of a whole model's A = R⁻¹ Φ_φ S, in double precision. S holds the nominal
/// magnitudes of the unknowns; R makes the row sums of |A| one.
class ScaledFactors {
 public:
  /// The model must outlive this object.
  explicit ScaledFactors(const Model& model);
  ~ScaledFactors();

  const WholeSystem& system() const { return system_; }
  int size() const { return system_.rows(); }

  /// Factorises at a state, with pivots chosen there. Returns whether A is regular in doubles.
  bool factor(std::span<const double> state);

  /// Solves A x = b in place (size()). Needs factors.
  void solve(std::vector<double>& x);
  /// Solves Φ_φ x = b in place (size()). Needs factors.
  void solve_unscaled(std::vector<double>& x);

 private:
  WholeSystem system_;
  std::vector<double> magnitude_, sums_;  // S and R
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

}  // namespace desmo
