#pragma once

#include <array>
#include <span>
#include <vector>

#include "cases/numbers/derived.h"
#include "formulations/model/model.h"
#include "formulations/model/partition.h"

namespace desmo {

/// Structure of the equations of an irreducible block. Blocks of equal shape have the same
/// equations; they differ in dimensions and in the states that they read. Local states are numbered
/// by first appearance; columns of Jacobians are the n unknowns, then the m inputs: coordinates
/// that other blocks or drivers determine.
struct BlockShape {
  static constexpr int max_operands = 5, max_rows = 3;

  /// A constraint, some or all of whose equations belong to the block.
  struct Object {
    int kind;
    std::array<int, max_operands> operands;  ///< first local state of each
    std::array<int, max_rows> rows;          ///< row in the block; -1: of another block
    int first_constant;
    /// Position in `entries` of each entry that Kind::jacobian emits. -1: none.
    std::vector<int> slots;
    bool operator==(const Object&) const = default;
  };

  int unknowns = 0, inputs = 0;  ///< n, m
  std::vector<Object> objects;
  std::vector<int> columns;  ///< of each local state; or one of these:
  static constexpr int fixed = -1, unread = -2;
  /// Columns of the entries of Φ_q that are not always zero, row by row, each in ascending order.
  std::vector<int> entries;
  std::vector<int> row_begins;  ///< position of each row's first entry, and the end (n + 1)
  /// The same entries column by column: position of each column's first one, and the end (n + m +
  /// 1); row and position in `entries` of each.
  std::vector<int> column_begins, column_rows, column_entries;
  std::vector<int> input_begins;  ///< position of each row's first entry of an input (n)
  bool linear = true;             ///< Φ_q is constant
  bool operator==(const BlockShape&) const = default;

  int width() const { return unknowns + inputs; }
  int states() const { return static_cast<int>(columns.size()); }
};

/// Calls a function with the number of unknowns where loops over them are to be unrolled, else with
/// 0. Most blocks have one unknown or three.
template <class Function>
void with_unrolled_size(int unknowns, Function&& function) {
  unknowns == 1   ? function.template operator()<1>()
  : unknowns == 3 ? function.template operator()<3>()
                  : function.template operator()<0>();
}

/// An irreducible block of a model.
struct ShapedBlock {
  BlockShape shape;
  std::vector<int> states;       ///< position of each local state in the state of the model
  std::vector<int> coordinates;  ///< coordinate of each column
  std::vector<Derived> constants;
  std::vector<Remainder> remainders;  ///< of each local state; empty: none
  /// Bounds on how far each row of Φ may be off (n); empty: none. They count for positions alone:
  /// rates and paths have no bound for it.
  std::vector<double> slack;
  std::vector<double> initial;  ///< Φ₀ of a homotopy (n); empty: none

  /// Returns the coordinates of the inputs (m).
  std::span<const int> inputs() const { return std::span(coordinates).subspan(shape.unknowns); }
};

ShapedBlock shaped_block(const Model& model, const PartDefinition& block);

}  // namespace desmo
