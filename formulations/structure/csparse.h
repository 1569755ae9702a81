#pragma once

#include <cs.h>

#include <memory>

namespace desmo {

/// Deleter for the matrices and decompositions that CXSparse allocates.
struct FreeCSparse {
  void operator()(cs_di* matrix) const { cs_di_spfree(matrix); }
  void operator()(cs_did* form) const { cs_di_dfree(form); }
};

using CSparseMatrix = std::unique_ptr<cs_di, FreeCSparse>;
/// A Dulmage–Mendelsohn decomposition (block triangular form) of a sparse matrix.
using CSparseForm = std::unique_ptr<cs_did, FreeCSparse>;

}  // namespace desmo
