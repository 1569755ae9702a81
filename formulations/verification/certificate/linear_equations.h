#pragma once

#include <vector>

#include "cases/numbers/compensated.h"
#include "cases/numbers/interval.h"
#include "formulations/base/per_level.h"
#include "formulations/verification/certificate/block_shape.h"
#include "formulations/verification/certificate/lane_numbers.h"
#include "formulations/verification/certificate/taylor_model.h"

namespace desmo {

using LaneInterval = BasicInterval<LaneNumbers>;

/// Degree of the Taylor models in which Φ is evaluated along a path: that of the path, a quintic.
inline constexpr int path_degree = 5;
/// A state along a path, from which Φ is evaluated.
using PathValue = TaylorModel<LaneNumbers, path_degree>;
/// A state along a path, from which Φ_q is evaluated. Where points move together, linear parts
/// cancel in their differences; intervals would add up.
using PathSlope = TaylorModel<LaneNumbers, 1>;

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
  /// Sets an entry to an interval of its values along a path; -1: none. It is inlined, since a call
  /// would cost as much.
  [[gnu::always_inline]] void set(int entry, const PathSlope& value) {
    if (entry >= 0) set(entry, {value.c[0], value.variation()});
  }
};

/// The equations of linear kinds among the n equations of a batch: Φ = Σ factor × local state +
/// Φ(0). Proofs about instants and proofs about paths share them.
class LinearEquations {
 public:
  LinearEquations() = default;
  /// Takes the linear equations of a shape.
  /// - constants: those of all objects, one after the other
  /// - fixed: values of local states, 0 for those of coordinates
  LinearEquations(const BlockShape& shape, const std::vector<Compensated<LaneNumbers>>& constants,
                  const std::vector<Compensated<LaneNumbers>>& fixed);

  /// Evaluates Φ and its time derivatives up to a level at the midpoints of x, in compensated
  /// arithmetic. Overwrites the rows of linear equations in phi.
  void motion(const PerLevel<std::vector<LaneInterval>>& x, Level level,
              PerLevel<std::vector<LaneInterval>>& phi) const;
  /// Evaluates Φ along a path. Overwrites the same rows.
  void residual(const PathValue* x, PathValue* phi) const;
  /// Writes the entries of linear equations in Φ_q, as midpoints and radii, and zeros elsewhere.
  void jacobian(LaneMatrix& to) const;

 private:
  /// A term of an equation: factor × local state.
  struct Term {
    int state;
    int slot;  ///< position in BlockShape::entries; -1: none
    Compensated<LaneNumbers> factor;
    LaneInterval enclosed;  ///< the factor, as an interval about its double
  };
  struct Equation {
    int row;                 ///< row in the block
    LaneInterval at_origin;  ///< Φ(0), as an interval about its double
    /// Φ(0) + Σ factor × (number of the file − double) of fixed states.
    Compensated<LaneNumbers> offset;
    std::vector<Term> terms;
  };

  void add(const BlockShape::Object& object, const Compensated<LaneNumbers>* constants);

  std::vector<Equation> equations_;
  bool has_offsets_ = false;  // the offset of some equation is not 0
};

}  // namespace desmo
