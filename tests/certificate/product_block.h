// A block of one equation, made by hand.
#pragma once

#include <optional>
#include <vector>

#include "formulations/constraints/constraints.h"
#include "formulations/verification/certificate/block_proof.h"

namespace desmo {

/// Returns tables of so many rows.
inline PerLevel<ErrorTable> tables_of(int rows) {
  PerLevel<ErrorTable> errors;
  for (const Level level : all_levels) errors[level].rows.resize(rows);
  return errors;
}

/// An equation u·v = c, of which only the first component of u is unknown.
inline BlockBatch::Member product_of_vectors(double c) {
  BlockBatch::Member made{{}, 0, 0, 0, Level::acceleration, {0, 1, 2, 3, 4, 5}};
  BlockShape& s = made.block.shape;
  s.unknowns = 1;
  s.inputs = 5;
  s.linear = false;
  s.columns = s.entries = s.column_entries = made.rows;
  s.column_rows = {0, 0, 0, 0, 0, 0};
  s.row_begins = {0, 6};
  s.input_begins = {1};
  s.column_begins = {0, 1, 2, 3, 4, 5, 6};
  s.objects.push_back({kind_index<Dot<3>>(), {0, 3}, {0, -1, -1}, 0, {0, 3, 1, 4, 2, 5}});
  made.block.states = made.block.coordinates = made.rows;
  made.block.constants = {c};
  return made;
}

/// A proof about that block alone. Rows of its tables are u₁ u₂ u₃ v₁ v₂ v₃. With symbols, it is in
/// a link of a chain: the same rows are lent after those.
struct ProductBlock {
  static constexpr int rows = 6;

  explicit ProductBlock(BlockBatch::Member member, int symbols = 0)
      : errors(tables_of(symbols > 0 ? 2 * rows : rows)),
        proof({.unknowns = 1, .width = rows, .states = rows, .columns = symbols}) {
    for (int& row : member.rows) row += symbols > 0 ? rows : 0;
    batch.emplace(std::vector{member}, std::vector<double>(rows, 1), symbols);
    for (const Level level : all_levels) {
      errors[level].generators.resize(rows * symbols);
      errors[level].columns = symbols;
      errors[level].first_lent = rows;
    }
  }
  explicit ProductBlock(double c, int symbols = 0) : ProductBlock(product_of_vectors(c), symbols) {}

  bool prove(Level level) { return proof.prove(*batch, level, errors)[level][0]; }

  std::optional<BlockBatch> batch;
  PerLevel<ErrorTable> errors;
  BlockProof proof;
};

}  // namespace desmo
