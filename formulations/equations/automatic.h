#pragma once

#include <array>
#include <tuple>
#include <vector>

#include "cases/mechanism.h"
#include "formulations/equations/pattern.h"
#include "formulations/partition.h"

namespace desmo {

/// Automatic equations: a loop over the constraint objects of a part. Objects of one kind stand
/// together, so that no call in the loop is virtual; the positions of their partial derivatives
/// are looked up once. Real is double or float.
///
/// This class and SymbolicEquations meet the same contract, which NewtonPart relies on. `state`
/// and `rate` are the state and its time derivative (Mechanism::state_size()), `values` has
/// pattern().size() values, `phi` and `gamma` pattern().n.
template <class S>
class BasicAutomaticEquations {
 public:
  using Real = S;

  BasicAutomaticEquations(const Mechanism& mechanism, const PartDefinition& part);

  const Pattern& pattern() const { return pattern_; }

  /// Partial derivatives that never change: called once, before the others.
  void constant_jacobian(Real* values) const;
  /// phi = Φ, overwritten.
  void residual(const Real* state, Real* phi) const;
  /// Writes the entries of Φ_φ that change, except those of constant_jacobian().
  void jacobian(const Real* state, Real* values) const;
  /// Writes the entries of Φ_h that change; the loop of jacobian() has already done so.
  void known_jacobian(const Real*, Real*) const {}
  /// gamma = Φ̇_q q̇ (eq. 4), overwritten.
  void quadratic(const Real* state, const Real* rate, Real* gamma) const;

 private:
  template <class Kind>
  struct Batch {
    struct Object {
      std::array<int, Kind::operand_sizes.size()> operands;  // in the state
      std::array<Real, Kind::constants> constants;
      int row;  // first of the part, when it has them all
      std::array<int, Kind::entries> slots;
      std::array<int, Kind::rows> rows;  // of the part, or -1 where another part has it
    };
    std::vector<Object> whole;  // all their equations belong to the part
    std::vector<Object> cut;    // some do
  };
  template <class Tuple>
  struct BatchesOf;
  template <class... Kinds>
  struct BatchesOf<std::tuple<Kinds...>> {
    using type = std::tuple<Batch<Kinds>...>;
  };
  using Batches = typename BatchesOf<ConstraintKinds>::type;

  /// The loops over the objects of one batch.
  struct Loops {
    void (*constant_jacobian)(const Batches&, Real* values);
    void (*residual)(const Batches&, const Real* state, Real* phi);
    void (*jacobian)(const Batches&, const Real* state, Real* values);
    void (*quadratic)(const Batches&, const Real* state, const Real* rate, Real* gamma);
  };
  template <class Kind, bool Whole>
  struct LoopsOf;

  Pattern pattern_;
  Batches batches_;
  std::vector<const Loops*> loops_;  // of the batches that have objects: a part has few kinds
};

using AutomaticEquations = BasicAutomaticEquations<double>;

}  // namespace desmo
