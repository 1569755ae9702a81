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
/// constraint kinds. States are local (BlockShape::states()): at an instant in intervals, of which
/// Φ and its rates use only the midpoints; along a path as functions of s in [−1, 1] in Taylor
/// models. Results have n equations.
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
  /// Evaluates the entries of Φ̇_q that vary; at Level::acceleration those of Φ̈_q, too. Sets
  /// constant entries to zero at `level` alone: velocity comes before acceleration.
  void jacobian_rates(const States& x, Level level, PerLevel<LaneMatrix>& to) const;

  // In path_equations.cpp.
  /// Writes the states of a path that are fixed or that no equation reads.
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
    const Compensated<LaneNumbers>* fixed;  ///< of local states
    bool quadratic;  ///< each entry of Φ_q is constant or homogeneous of degree 1 in q
    std::vector<int> rate_slots;  ///< slots, with -1 for constant entries
  };
  void add(const BlockShape::Object& object);
  static PathFunctions path_functions(int kind);

  BlockShape shape_;
  std::vector<Compensated<LaneNumbers>> constants_;
  std::vector<LaneInterval> enclosed_constants_;
  std::vector<Compensated<LaneNumbers>> path_constants_;  // with radii about their doubles
  std::vector<Compensated<LaneNumbers>> fixed_;           // values of local states; 0 for others
  std::vector<LaneNumbers> radii_;                        // of these, about their doubles
  std::vector<int> written_;                              // states that write_fixed() writes
  std::vector<Object> objects_;
  LinearEquations linear_;
  std::vector<LaneNumbers> slack_;     // bound on the error of each row of Φ (n); empty: 0
  std::vector<int> constant_entries_;  // of Φ_q
};

}  // namespace desmo
