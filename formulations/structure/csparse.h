#pragma once

#include <cs.h>

#include <memory>
#include <new>

namespace desmo {

/// Deleter for the matrices and decompositions that CXSparse allocates.
struct FreeCSparse {
  void operator()(cs_di* matrix) const { cs_di_spfree(matrix); }
  void operator()(cs_did* form) const { cs_di_dfree(form); }
};

using CSparseMatrix = std::unique_ptr<cs_di, FreeCSparse>;
/// A Dulmage–Mendelsohn decomposition (block triangular form) of a sparse matrix.
using CSparseForm = std::unique_ptr<cs_did, FreeCSparse>;

/// Returns the decomposition of a matrix that is given as triplets.
inline CSparseForm decompose(const CSparseMatrix& triplets) {
  const CSparseMatrix matrix(cs_di_compress(triplets.get()));
  CSparseForm form(cs_di_dmperm(matrix.get(), 0));
  if (!form) throw std::bad_alloc();
  return form;
}

}  // namespace desmo
