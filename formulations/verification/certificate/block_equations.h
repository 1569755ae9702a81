#pragma once

#include <vector>

#include "cases/numbers/compensated.h"
#include "cases/numbers/interval.h"
#include "formulations/base/per_level.h"
#include "formulations/verification/certificate/block_shape.h"
#include "formulations/verification/certificate/lane_numbers.h"
#include "formulations/verification/certificate/linear_equations.h"

namespace desmo {

/// The n equations of up to four blocks of one shape, one in each lane. The functions of the
/// constraint kinds evaluate them. States are local (BlockShape::states() intervals). Φ and its
/// rates use only their midpoints.
class BlockEquations {
 public:
  using States = PerLevel<const LaneInterval*>;

  /// lanes: a block for each, all of one shape.
  explicit BlockEquations(const std::vector<const ShapedBlock*>& lanes);

  const BlockShape& shape() const { return shape_; }
  bool is_linear() const { return shape_.linear; }
  const LinearEquations& linear() const { return linear_; }
  /// Returns a bound on |number of the file − double| of a fixed local state; 0 for others.
  const LaneNumbers& radius(int state) const { return radii_[state]; }

  /// Evaluates Φ and its time derivatives up to a level in compensated arithmetic. Φ is widened by
  /// ShapedBlock::slack. Overwrites phi (n at each level).
  void motion(const States& x, Level level, const PerLevel<LaneInterval*>& phi) const;
  /// Evaluates Φ_q. Overwrites all entries of equations that are not linear.
  void jacobian(const LaneInterval* q, LaneMatrix& to) const;
  /// Evaluates the entries of Φ̇_q that vary; at Level::acceleration those of Φ̈_q, too. Sets
  /// constant entries to zero at `level` alone: velocity comes before acceleration.
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
    bool quadratic;  ///< each entry of Φ_q is constant or homogeneous of degree 1 in q
    std::vector<int> rate_slots;  ///< slots, with -1 for constant entries
  };
  void add(const BlockShape::Object& object);

  BlockShape shape_;
  std::vector<Compensated<LaneNumbers>> constants_;
  std::vector<LaneInterval> enclosed_constants_;
  std::vector<Compensated<LaneNumbers>> remainders_;  // of local states that are fixed, value 0
  std::vector<LaneNumbers> radii_;                    // bounds on |remainders|
  std::vector<Object> objects_;
  LinearEquations linear_;
  std::vector<LaneNumbers> slack_;     // bound on the error of each row of Φ (n); empty: 0
  std::vector<int> constant_entries_;  // of Φ_q
};

}  // namespace desmo
