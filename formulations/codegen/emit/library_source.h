#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formulations/codegen/record/sampled_type.h"

namespace desmo::generate {

/// What a library holds for each of its types beside symbolic equations and their elimination.
struct LibraryContents {
  bool explicit_order = false;
  int lanes = 1;  ///< of explicit order, besides one
};

/// C++ that a compiler makes a library of kernels from (see KernelLibrary), with no header but
/// those of the language: those of desmo are in it. Kernels that cannot be written are left out,
/// the reason in their place; empty when there are none. types: named, no two alike. The same types
/// and samples give the same bytes.
std::string library_source(const std::vector<SampledType>& types, LibraryContents contents);

/// A digest of all that decides which bytes library_source gives for its arguments.
std::string_view generator_digest();

}  // namespace desmo::generate
