#pragma once

#include <array>
#include <vector>

#include "formulations/base/per_level.h"
#include "formulations/model/model.h"
#include "formulations/structure/partition.h"
#include "formulations/verification/certificate/interval.h"

namespace desmo {

/// An interval matrix by rows, midpoints and radii apart. Rows have zeros at their ends, so that
/// their lengths are multiples of four.
struct IntervalMatrix {
  std::vector<double> mid, radius;
};

/// The n equations of one irreducible block in intervals, by the functions of the constraint kinds.
/// States (q, q̇, q̈) have Model::state_size() intervals; results have n, in the block's order.
class IntervalBlock {
 public:
  IntervalBlock(const Model& model, const PartDefinition& block);
  IntervalBlock(IntervalBlock&&) = default;  // objects point to their constants

  int size() const { return static_cast<int>(unknowns_.size()); }
  bool is_linear() const { return linear_; }                      ///< Φ_q is constant
  const std::vector<int>& unknowns() const { return unknowns_; }  ///< ascending (n)
  /// Returns the coordinates that the equations read and other blocks or drivers determine (m).
  const std::vector<int>& inputs() const { return inputs_; }

  /// Returns the length of the rows of matrices: n + m or a little more.
  int stride() const { return stride_of(unknowns_.size() + inputs_.size()); }
  static int stride_of(std::size_t columns) { return static_cast<int>(columns + 3) / 4 * 4; }

  /// Evaluates Φ. Overwrites phi.
  void residual(const Interval* q, Interval* phi) const;
  /// Evaluates Φ_q: derivatives by the unknowns, then by the inputs. Overwrites the entries of
  /// `to` (n rows) that are not always zero.
  void jacobian(const Interval* q, IntervalMatrix& to) const;
  /// Evaluates Φ and its time derivatives up to a level. Overwrites phi.
  void motion(const PerLevel<const Interval*>& state, Level level,
              const PerLevel<Interval*>& phi) const;
  /// Evaluates Φ̇_q and, at the level of accelerations, Φ̈_q; otherwise like jacobian(). Entries of
  /// equations whose derivatives are constant stay zero.
  void jacobian_rates(const PerLevel<const Interval*>& state, Level level,
                      PerLevel<IntervalMatrix>& to) const;
  /// Returns a matrix for these functions, all zero.
  IntervalMatrix make_matrix() const;

 private:
  static constexpr int max_operands = 5, max_rows = 3;
  struct Object;
  struct Functions;
  template <class Kind>
  struct FunctionsOf;

  /// A constraint, some or all of whose equations belong to the block.
  struct Object {
    const Functions* functions;
    std::array<int, max_operands> operands;  // positions in the state
    std::array<int, max_rows> rows;          // row in the block; -1: of another block
    const Interval* constants;
    std::vector<int> slots;  // position of each entry of its Jacobian
  };
  void add(const Model& model, const Constraint& constraint, const PartDefinition& block,
           int position);

  std::vector<int> unknowns_, inputs_;
  std::vector<Object> objects_;
  std::vector<std::vector<Interval>> constants_;  // of each object
  bool linear_ = true;
};

}  // namespace desmo
