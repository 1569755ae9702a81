#pragma once

#include "formulations/equations/pattern.h"

namespace desmo {

/// Constraint equations Φ of one part and their partial derivatives. Φ_φ are those by the part's n
/// unknowns φ, Φ_h those by the coordinates h that it takes as known. One call evaluates all
/// equations of the part, without a virtual call for a single equation. It runs a loop over
/// constraint objects (AutomaticEquations) or generated straight-line code (SymbolicEquations).
/// - state, rate: the state and its time derivative (Model::state_size())
/// - values: (pattern().size())
/// - phi, gamma: (n)
class Equations {
 public:
  virtual ~Equations() = default;

  virtual const Pattern& pattern() const = 0;

  /// Writes the partial derivatives that never change. Call it once, before the others.
  virtual void constant_jacobian(double* values) const = 0;
  /// Evaluates Φ. Overwrites phi.
  virtual void residual(const double* state, double* phi) const = 0;
  /// Writes the entries of Φ_φ that change; constant_jacobian() wrote the others.
  virtual void jacobian(const double* state, double* values) const = 0;
  /// Writes the changing entries of Φ_h, the derivatives by known coordinates, except those that
  /// jacobian() writes along with Φ_φ.
  virtual void known_jacobian(const double* state, double* values) const = 0;
  /// Evaluates the quadratic velocity term Φ̇_q q̇ (eq. 4). Overwrites gamma.
  virtual void quadratic(const double* state, const double* rate, double* gamma) const = 0;
};

}  // namespace desmo
