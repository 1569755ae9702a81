#pragma once

#include <vector>

#include "formulations/verification/certificate/block_batch.h"
#include "formulations/verification/certificate/taylor_model.h"

namespace desmo {

/// The equations of a batch of blocks along a path: functions of s in [−1, 1] in Taylor models, by
/// the functions of the constraint kinds. States are local (BlockShape::states()). Rows of Φ count
/// as exact: ShapedBlock::slack, which no model of a motion has, is not read.
class PathEquations {
 public:
  /// Degree of what residuals are evaluated in: that of the path, a quintic.
  static constexpr int degree = 5;
  using Value = TaylorModel<LaneNumbers, degree>;
  /// States of which derivatives are taken: what turns with the step is linear in s.
  using Slope = TaylorModel<LaneNumbers, 1>;

  /// The batch must outlive this, and stay where it is.
  PathEquations(const Model& model, const BlockBatch& batch);

  /// Writes the states that are fixed, and zeros for those that no equation reads.
  void write_fixed(Value* x) const;

  /// Evaluates Φ. Overwrites phi (n).
  void residual(const Value* x, Value* phi) const;
  /// Evaluates Φ_q over the whole path. Overwrites the entries of equations that are not linear.
  void jacobian(const Slope* x, LaneMatrix& to) const;

 private:
  struct Object;
  template <class Kind>
  struct FunctionsOf;

  struct Object {
    const BlockShape::Object* shape;
    const LaneInterval* constants;
    void (*residual)(const Object&, const Value* x, Value* phi);
    void (*jacobian)(const Object&, const Slope* x, LaneMatrix& to);
  };
  struct FixedState {
    int state;
    LaneInterval value;
  };
  void add(const BlockShape::Object& object);

  const LinearEquations& linear_;
  std::vector<LaneInterval> constants_;  // about the doubles, with what these lack
  std::vector<Object> objects_;          // that are not linear
  std::vector<FixedState> fixed_;
};

}  // namespace desmo
