#pragma once

#include <cs.h>

#include <algorithm>
#include <memory>
#include <new>
#include <span>
#include <utility>
#include <vector>

namespace desmo {

/// Deleter for the matrices and decompositions that CXSparse allocates.
struct FreeCSparse {
  void operator()(cs_di* matrix) const { cs_di_spfree(matrix); }
  void operator()(cs_did* form) const { cs_di_dfree(form); }
};

using CSparseMatrix = std::unique_ptr<cs_di, FreeCSparse>;
/// A Dulmage–Mendelsohn decomposition (block triangular form) of a sparse matrix.
using CSparseForm = std::unique_ptr<cs_did, FreeCSparse>;

/// Returns the decomposition of a matrix with ones at these (row, column).
inline CSparseForm decompose(int rows, int columns, std::span<const std::pair<int, int>> ones) {
  const int entries = std::max(1, static_cast<int>(ones.size()));
  const CSparseMatrix triplets(cs_di_spalloc(rows, columns, entries, 1, 1));
  if (!triplets) throw std::bad_alloc();
  for (const auto& [row, column] : ones) cs_di_entry(triplets.get(), row, column, 1);
  const CSparseMatrix matrix(cs_di_compress(triplets.get()));
  CSparseForm form(cs_di_dmperm(matrix.get(), 0));
  if (!form) throw std::bad_alloc();
  return form;
}

/// An irreducible block of a matrix: its rows and columns, ascending.
struct MatrixBlock {
  std::vector<int> rows, columns;
};

/// Returns the blocks in solution order. The form is upper triangular: the last block depends on no
/// other.
inline std::vector<MatrixBlock> blocks_in_order(const cs_did& form) {
  std::vector<MatrixBlock> blocks;
  for (int b = form.nb - 1; b >= 0; --b) {
    MatrixBlock block{{form.p + form.r[b], form.p + form.r[b + 1]},
                      {form.q + form.s[b], form.q + form.s[b + 1]}};
    std::ranges::sort(block.rows);
    std::ranges::sort(block.columns);
    blocks.push_back(std::move(block));
  }
  return blocks;
}

}  // namespace desmo
