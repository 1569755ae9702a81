#pragma once

#include <vector>

#include "formulations/verification/certificate/block_batch.h"
#include "formulations/verification/certificate/taylor_model.h"

namespace desmo {

/// The equations of a batch along a path, as functions of s in [−1, 1] in Taylor models. The
/// functions of the constraint kinds evaluate them. States are local (BlockShape::states()). Rows
/// of Φ count as exact: ShapedBlock::slack, which no model of a motion has, is not read.
class PathEquations {
 public:
  /// Degree of the Taylor models of Φ: that of the path, a quintic.
  static constexpr int degree = 5;
  using Value = TaylorModel<LaneNumbers, degree>;
  /// Scalar of Φ_q. Linear parts of points that move together cancel in differences, where plain
  /// intervals would add up.
  using Slope = TaylorModel<LaneNumbers, 1>;

  /// The batch must outlive this object, and stay where it is.
  PathEquations(const Model& model, const BlockBatch& batch);

  /// Writes the fixed states, and zeros for states that no equation reads.
  void write_fixed(Value* x) const;

  /// Evaluates Φ. Overwrites phi (n).
  void residual(const Value* x, Value* phi) const;
  /// Encloses Φ_q for all s at once: midpoint at s = 0. Overwrites the entries of equations that
  /// are not linear.
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
  std::vector<LaneInterval> constants_;  // midpoints: doubles; radii: what these lack
  std::vector<Object> objects_;          // constraints that are not linear
  std::vector<FixedState> fixed_;
};

}  // namespace desmo
