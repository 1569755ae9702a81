#pragma once

#include <vector>

#include "cases/numbers/compensated.h"
#include "cases/numbers/interval.h"
#include "formulations/base/per_level.h"
#include "formulations/verification/certificate/block_shape.h"
#include "formulations/verification/certificate/lane_numbers.h"
#include "formulations/verification/certificate/linear_equations.h"

namespace desmo {

/// The n equations of up to four blocks of one shape, one in each lane, by the functions of the
/// constraint kinds. States are local, in intervals (BlockShape::states()); results have n
/// equations. Φ and its rates use only the midpoints of states.
class BlockEquations {
 public:
  using States = PerLevel<const LaneInterval*>;

  /// lanes: a block for each, all of one shape.
  explicit BlockEquations(const std::vector<const ShapedBlock*>& lanes);

  const BlockShape& shape() const { return shape_; }
  bool is_linear() const { return shape_.linear; }
  const LinearEquations& linear() const { return linear_; }
  /// Returns by how much a fixed local state may differ from its double; 0 for others.
  const LaneNumbers& radius(int state) const { return radii_[state]; }

  /// Evaluates Φ and its time derivatives up to a level, nearly without rounding. Overwrites phi.
  void motion(const States& x, Level level, const PerLevel<LaneInterval*>& phi) const;
  /// Evaluates Φ_q. Overwrites all entries of equations that are not linear.
  void jacobian(const LaneInterval* q, LaneMatrix& to) const;
  /// Evaluates Φ̇_q and, at the level of accelerations, Φ̈_q: entries that vary. Sets constant ones
  /// to zero, at `level` alone.
  void jacobian_rates(const States& x, Level level, PerLevel<LaneMatrix>& to) const;

 private:
  struct Functions;
  template <class Kind>
  struct FunctionsOf;

  /// A constraint that is not linear.
  struct Object {
    const Functions* functions;
    const BlockShape::Object* shape;
    const Compensated<LaneNumbers>* constants;
    const LaneInterval* enclosed_constants;
    const Compensated<LaneNumbers>* remainders;  ///< of local states
    bool quadratic;                              ///< Φ_q is constant or linear in each entry
    std::vector<int> rate_slots;                 ///< slots without those of constant entries
  };
  void add(const BlockShape::Object& object);

  BlockShape shape_;
  std::vector<Compensated<LaneNumbers>> constants_;
  std::vector<LaneInterval> enclosed_constants_;
  std::vector<Compensated<LaneNumbers>> remainders_;  // of local states that are fixed, value 0
  std::vector<LaneNumbers> radii_;                    // the same as radii of the values
  std::vector<Object> objects_;
  LinearEquations linear_;
  std::vector<LaneNumbers> slack_;     // by how much each row of Φ may be off; empty: none
  std::vector<int> constant_entries_;  // of Φ_q
};

}  // namespace desmo
