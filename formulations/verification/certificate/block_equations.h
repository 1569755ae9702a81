#pragma once

#include <vector>

#include "cases/numbers/compensated.h"
#include "cases/numbers/interval.h"
#include "formulations/base/per_level.h"
#include "formulations/verification/certificate/block_shape.h"
#include "formulations/verification/certificate/lane_numbers.h"
#include "formulations/verification/certificate/linear_equations.h"

namespace desmo {

/// The n equations of up to four blocks of one shape, one in each lane. Functions of the constraint
/// kinds evaluate all but linear ones. Arguments are the local states (BlockShape::states()). At an
/// instant these are intervals, of which Φ and its rates use only the midpoints. Along a path they
/// are functions of s in [−1, 1], enclosed in Taylor models.
class BlockEquations {
 public:
  using States = PerLevel<std::vector<LaneInterval>>;

  /// lanes: a block for each, all of one shape.
  explicit BlockEquations(const std::vector<const ShapedBlock*>& lanes);
  BlockEquations(BlockEquations&&) = default;  // objects point into the vectors: no copies
  BlockEquations& operator=(BlockEquations&&) = default;

  const BlockShape& shape() const { return shape_; }
  const LinearEquations& linear() const { return linear_; }
  /// Returns a bound on |number of the file − double| of a fixed local state; 0 for others.
  const LaneNumbers& radius(int state) const { return radii_[state]; }

  /// Evaluates Φ and its time derivatives up to a level in compensated arithmetic. Φ is widened by
  /// ShapedBlock::slack. Overwrites phi (n at each level).
  void motion(const States& x, Level level, States& phi) const;
  /// Evaluates Φ_q. Overwrites all entries of equations that are not linear.
  void jacobian(const LaneInterval* q, LaneMatrix& to) const;
  /// Evaluates Φ̇_q and, at Level::acceleration, Φ̈_q. Call it at Level::velocity first: constant
  /// entries of Φ_q get their zeros at `level` alone.
  void jacobian_rates(const States& x, Level level, PerLevel<LaneMatrix>& to) const;

  // In path_equations.cpp.
  /// Writes the fixed states of a path, and those that no equation of the block depends on, since
  /// functions take them, too.
  void write_fixed(PathValue* x) const;
  /// Evaluates Φ along a path. Overwrites phi. Rows count as exact: ShapedBlock::slack, which no
  /// model of a motion has, is not read.
  void residual(const PathValue* x, PathValue* phi) const;
  /// Evaluates Φ_q over the whole path. Overwrites all entries of equations that are not linear.
  void jacobian(const PathSlope* x, LaneMatrix& to) const;

 private:
  template <class Kind>
  struct FunctionsOf;
  struct Object;

  /// Functions of a constraint kind. slots: position in `to` of each entry of the kind's Jacobian.
  struct Functions {
    void (*motion)(const Object&, const States& x, Level, States& phi);
    void (*jacobian)(const Object&, const std::vector<int>& slots, const LaneInterval* q,
                     LaneMatrix& to);
    void (*jacobian_rates)(const Object&, const States& x, Level, PerLevel<LaneMatrix>& to);
  };
  struct PathFunctions {
    void (*residual)(const Object&, const PathValue* x, PathValue* phi);
    void (*jacobian)(const Object&, const std::vector<int>& slots, const PathSlope* x,
                     LaneMatrix& to);
  };
  /// A constraint that is not linear.
  struct Object {
    Functions functions;
    PathFunctions path_functions;
    const BlockShape::Object* shape;
    const Compensated<LaneNumbers>* constants;
    const LaneInterval* enclosed_constants;
    const Compensated<LaneNumbers>* path_constants;
    const Compensated<LaneNumbers>* fixed;  ///< fixed_ of BlockEquations
    bool quadratic;  ///< each entry of Φ_q is constant or homogeneous of degree 1 in q
    std::vector<int> rate_slots;  ///< slots, with -1 for constant entries
  };
  void add(const BlockShape::Object& object);
  static PathFunctions path_functions(int kind);

  BlockShape shape_;
  std::vector<Compensated<LaneNumbers>> constants_;
  std::vector<LaneInterval> enclosed_constants_;
  std::vector<Compensated<LaneNumbers>> path_constants_;  // corrections are part of the radii
  std::vector<Compensated<LaneNumbers>> fixed_;           // fixed local states; 0 for others
  std::vector<LaneNumbers> radii_;                        // see radius()
  std::vector<int> written_;                              // states that write_fixed() writes
  std::vector<Object> objects_;
  LinearEquations linear_;
  std::vector<LaneNumbers> slack_;     // bound on the error of each row of Φ (n); empty: 0
  std::vector<int> constant_entries_;  // entries of Φ_q that are constant
};

}  // namespace desmo
