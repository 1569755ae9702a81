#pragma once

#include <memory>
#include <span>
#include <vector>

#include "formulations/verification/reference/whole_system.h"

namespace desmo {

/// Sparse LU factors of A = R⁻¹ Φ_φ S, all equations of a model at once, in double precision. S
/// holds the nominal magnitudes of the unknowns, R the row sums of |Φ_φ S|.
class ScaledFactors {
 public:
  /// The model must outlive this object.
  explicit ScaledFactors(const Model& model);
  ~ScaledFactors();

  const WholeSystem& system() const { return system_; }
  int size() const { return system_.rows(); }

  /// Factorises A at a state, with pivots chosen there. Returns whether A is regular in doubles.
  bool factor(std::span<const double> state);

  /// Solves A x = b (size()) in place: b, then x. Needs a factor() that returned true.
  void solve(std::vector<double>& x);
  /// Solves Φ_φ x = b likewise.
  void solve_unscaled(std::vector<double>& x);

 private:
  WholeSystem system_;
  std::vector<double> magnitude_, sums_;  // S and R
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

}  // namespace desmo
