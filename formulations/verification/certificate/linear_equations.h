#pragma once

#include <vector>

#include "cases/numbers/compensated.h"
#include "cases/numbers/interval.h"
#include "formulations/base/per_level.h"
#include "formulations/verification/certificate/block_shape.h"
#include "formulations/verification/certificate/lane_numbers.h"

namespace desmo {

using LaneInterval = BasicInterval<LaneNumbers>;

/// An interval matrix for each lane, with the entries that BlockShape::entries lists. Midpoints and
/// radii are kept apart.
struct LaneMatrix {
  std::vector<LaneNumbers> mid, radius;

  void resize(int entries) { mid.resize(entries), radius.resize(entries); }
  /// Sets an entry; -1: none.
  void set(int entry, const LaneInterval& value) {
    if (entry < 0) return;
    mid[entry] = value.mid;
    radius[entry] = value.radius;
  }
};

/// The linear ones among the n equations of a batch: Φ = Σ factor × local state + Φ(0). Proofs
/// about instants and proofs about paths share them.
class LinearEquations {
 public:
  /// A term of an equation: factor × local state.
  struct Term {
    int state;
    int slot;  ///< position in BlockShape::entries; -1: none
    Compensated<LaneNumbers> factor;
    LaneInterval enclosed;  ///< the factor, as an interval about its double
  };
  struct Equation {
    int row;                          ///< of the block
    LaneInterval at_origin;           ///< Φ(0), as an interval about its double
    Compensated<LaneNumbers> offset;  ///< Φ(0) + Σ factor × remainder of a fixed state
    std::vector<Term> terms;
  };

  LinearEquations() = default;
  /// Takes the linear equations of a shape.
  /// - constants: those of all objects, one after the other
  /// - remainders: numbers of the file minus their doubles, for fixed local states; 0 for others
  LinearEquations(const BlockShape& shape, const std::vector<Compensated<LaneNumbers>>& constants,
                  const std::vector<Compensated<LaneNumbers>>& remainders);

  const std::vector<Equation>& equations() const { return equations_; }

  /// Evaluates Φ and its time derivatives up to a level at the midpoints of x, in compensated
  /// arithmetic. Overwrites the rows of linear equations in phi.
  void motion(const PerLevel<const LaneInterval*>& x, Level level,
              const PerLevel<LaneInterval*>& phi) const;
  /// Writes the entries of linear equations in Φ_q, as midpoints and radii, and zeros elsewhere.
  void jacobian(LaneMatrix& to) const;

 private:
  void add(const BlockShape::Object& object, const Compensated<LaneNumbers>* constants);

  std::vector<Equation> equations_;
  bool has_offsets_ = false;  // the offset of some equation is not 0
};

}  // namespace desmo
