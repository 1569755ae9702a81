#pragma once

#include "formulations/equations/pattern.h"

namespace desmo {

/// The constraint equations Φ of one part and their partial derivatives. `state` and `rate` are the
/// state and its time derivative (Model::state_size()); `values` has pattern().size() values,
/// `phi` and `gamma` pattern().n. Real is double or float.
///
/// One call evaluates all equations of the part; what it runs is a loop over constraint objects
/// (AutomaticEquations) or generated straight-line code (SymbolicEquations), neither of which makes
/// a virtual call for a single equation.
template <class Real>
class Equations {
 public:
  virtual ~Equations() = default;

  virtual const Pattern& pattern() const = 0;

  /// Writes the partial derivatives that never change. Called once, before the others.
  virtual void constant_jacobian(Real* values) const = 0;
  /// phi = Φ, overwritten.
  virtual void residual(const Real* state, Real* phi) const = 0;
  /// Writes the entries of Φ_φ that change, those of constant_jacobian() apart.
  virtual void jacobian(const Real* state, Real* values) const = 0;
  /// Writes the entries of Φ_h that change and that jacobian() has not written.
  virtual void known_jacobian(const Real* state, Real* values) const = 0;
  /// gamma = Φ̇_q q̇ (eq. 4), overwritten.
  virtual void quadratic(const Real* state, const Real* rate, Real* gamma) const = 0;
};

}  // namespace desmo
