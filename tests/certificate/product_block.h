// Blocks that are proven by themselves, and one of a single equation.
#pragma once

#include <array>
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

/// Returns a part of a model as a block whose coordinates have the rows of their numbers.
inline BlockBatch::PlacedBlock placed_block(const Model& m, const PartDefinition& part) {
  BlockBatch::PlacedBlock made{
      shaped_block(m, part), part.groups.front(), 0, Level::acceleration, {}};
  made.rows = made.block.coordinates;
  return made;
}

/// Returns a prover that is large enough for a batch.
inline BlockProof proof_for(const BlockBatch& batch) {
  const BlockShape& s = batch.equations.shape();
  return BlockProof(
      {.unknowns = s.unknowns, .width = s.width(), .states = s.states(), .columns = 0});
}

/// An equation u·v = c, of which only the first component of u is unknown.
inline BlockBatch::PlacedBlock product_of_vectors(double c) {
  Model m;
  const GroupId group = m.add_group("block", {});
  for (const char* name : {"u", "v"})
    m.add(EntityKind::vector, name, std::array<double, 3>{}, group);
  m.add({"product", kind_index<Dot<3>>(), {0, 1}, {c}, group});
  return placed_block(m, {.groups = {group}, .unknowns = {0}, .equations = {{0, 0}}});
}

/// A proof about that block alone. Rows of its tables are u₁ u₂ u₃ v₁ v₂ v₃. With symbols, it is in
/// a link of a chain: the same rows are lent after those.
struct ProductBlock {
  static constexpr int rows = 6;

  explicit ProductBlock(BlockBatch::PlacedBlock placed, int symbols = 0)
      : errors(tables_of(symbols > 0 ? 2 * rows : rows)),
        proof({.unknowns = 1, .width = rows, .states = rows, .columns = symbols}) {
    for (int& row : placed.rows) row += symbols > 0 ? rows : 0;
    batch.emplace(std::vector{placed}, std::vector<double>(rows, 1), symbols);
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
