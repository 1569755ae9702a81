#pragma once

#include <memory>
#include <vector>

#include "formulations/equations/equations.h"
#include "formulations/model/model.h"
#include "formulations/model/partition.h"

namespace desmo {

/// Automatic equations: loops over the constraint objects of a part. Objects of one kind are
/// contiguous, so that no call in a loop is virtual. The constructor looks up the positions of
/// their partial derivatives. Real is double or float.
template <class Real>
class BasicAutomaticEquations final : public Equations<Real> {
 public:
  BasicAutomaticEquations(const Model& model, const PartDefinition& part);
  ~BasicAutomaticEquations() override;

  const Pattern& pattern() const override { return pattern_; }
  void constant_jacobian(Real* values) const override;
  void residual(const Real* state, Real* phi) const override;
  void jacobian(const Real* state, Real* values) const override;
  /// Does nothing: the loop of jacobian() has written these entries.
  void known_jacobian(const Real*, Real*) const override {}
  void quadratic(const Real* state, const Real* rate, Real* gamma) const override;

 private:
  template <class Kind>
  struct SameKind;  // objects of one kind
  struct AllKinds;  // a SameKind for every kind
  struct Loops;     // loops over the objects of one SameKind
  template <class Kind, bool Whole>
  struct LoopsOf;

  Pattern pattern_;
  std::unique_ptr<AllKinds> all_kinds_;
  std::vector<const Loops*> loops_;  // loops of the batches that have objects; a part has few kinds
};

using AutomaticEquations = BasicAutomaticEquations<double>;

}  // namespace desmo
