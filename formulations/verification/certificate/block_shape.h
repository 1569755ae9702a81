#pragma once

#include <array>
#include <span>
#include <vector>

#include "cases/numbers/derived.h"
#include "formulations/constraints/kinds.h"
#include "formulations/model/model.h"
#include "formulations/model/partition.h"

namespace desmo {

/// Structure of the equations of an irreducible block. Blocks of equal shape have the same
/// equations; they differ in dimensions and in the states that they read. The states that a block
/// reads are its local states, numbered by first appearance. Columns of Jacobians are the n
/// unknowns, then the m inputs: coordinates that other blocks or drivers determine.
struct BlockShape {
  /// A constraint, some or all of whose equations belong to the block.
  struct Object {
    int kind;
    std::array<int, max_operands> operands;  ///< first local state of each
    std::array<int, max_rows> rows;          ///< row in the block; -1: not of this block
    int first_constant;
    /// Position in `entries` of each entry that Kind::jacobian emits. -1: its row is not of this
    /// block, or its state is fixed.
    std::vector<int> slots;
    bool operator==(const Object&) const = default;
  };

  int unknowns = 0, inputs = 0;  ///< n, m
  std::vector<Object> objects;
  /// Column of each local state. `unread`: no equation of the block depends on the state. `fixed`:
  /// one does, but the state is that of a fixed entity.
  std::vector<int> columns;
  static constexpr int fixed = -1, unread = -2;
  /// Column of each entry of Φ_q that is not always zero, row by row, ascending in a row.
  std::vector<int> entries;
  std::vector<int> row_begins;  ///< position of each row's first entry, and the end (n + 1)
  /// The same entries column by column.
  /// - column_rows, column_entries: row of each entry, and its position in `entries`
  /// - column_begins: position in these of each column's first entry, and the end (n + m + 1)
  std::vector<int> column_begins, column_rows, column_entries;
  std::vector<int> input_begins;  ///< position of each row's first input entry, else its end (n)
  bool linear = true;             ///< all constraints are of linear kinds, so Φ_q is constant
  bool operator==(const BlockShape&) const = default;

  int width() const { return unknowns + inputs; }
  int states() const { return static_cast<int>(columns.size()); }
};

/// Calls function.operator()<N>(). N is the number of unknowns where loops over them are to be
/// unrolled, else 0. Most blocks have one unknown or three.
template <class Function>
void with_unrolled_size(int unknowns, Function&& function) {
  unknowns == 1   ? function.template operator()<1>()
  : unknowns == 3 ? function.template operator()<3>()
                  : function.template operator()<0>();
}

/// A part of a model, as a rule an irreducible block.
struct ShapedBlock {
  BlockShape shape;
  std::vector<int> states;       ///< position of each local state in the state of the model
  std::vector<int> coordinates;  ///< coordinate of each column
  std::vector<Derived> constants;
  std::vector<Derived> fixed;  ///< values of local states; 0 for those of coordinates
  /// Bound on the error of each row of Φ (n), from Constraint::slack; 0: exact. Only proofs of
  /// positions count it: a model with slack gets no proofs of rates or paths.
  std::vector<double> slack;
  std::vector<double> initial;  ///< Φ₀ of a homotopy (n); empty: none

  /// Returns the coordinates of the inputs (m).
  std::span<const int> inputs() const { return std::span(coordinates).subspan(shape.unknowns); }
};

/// Returns the shape and the numbers of a part of the model.
ShapedBlock shaped_block(const Model& model, const PartDefinition& block);

}  // namespace desmo
