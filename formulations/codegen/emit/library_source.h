#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formulations/codegen/record/recording.h"

namespace desmo::generate {

/// The optional contents of a library, in addition to symbolic equations and their elimination.
struct LibraryContents {
  bool explicit_order = false;
  int lanes = 1;  ///< lanes of the explicit kernels for batches; 1: scalar kernels only
};

/// Returns the texts of the headers of desmo that generated kernels need, each after those it
/// includes; only code for batches needs the last one. The program contains them, so that it can
/// compile generated code wherever it is installed.
std::span<const std::string_view> kernel_headers();

/// Returns the C++ source of a library of kernels (see KernelLibrary). It includes only headers of
/// the standard library; it contains the text of desmo's. A kernel that cannot be written is
/// replaced by a comment with the reason. Returns an empty string when no kernel can be written.
/// The same arguments give the same bytes. types: with distinct names.
std::string library_source(const std::vector<SampledType>& types, LibraryContents contents);

}  // namespace desmo::generate
