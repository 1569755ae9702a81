#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "formulations/runtime/wanted_types.h"

namespace desmo::load {

/// What became of the code that a formulation needs beside what desmo was built with.
struct OwnKernels {
  std::vector<TypeUse> types;    ///< that code was wanted for
  int parts_too_large = 0;       ///< to want any for them
  bool compiled = false;         ///< now, rather than before
  std::string compiler;          ///< its file and version
  std::string folder;            ///< of the cache
  double seconds = 0;            ///< that all of it took …
  double seconds_compiling = 0;  ///< … and of these the compiler
  std::string problem;           ///< why there is no code for `types`; empty when there is
};

/// Adds code for the parts of a formulation of types for which the table has none, generated for
/// the mechanism, its motion sampled over the grid: loaded from the user's cache when it was
/// compiled before, else compiled in at most `compile_time`. Whatever goes wrong is said in the
/// result and leaves the table as it was. Nothing of the mechanism's names gets into the code, and
/// nothing of the mechanism at all into file names and arguments, but as a digest.
OwnKernels add_own_kernels(KernelTable& table, const Variant& variant, const Settings& settings,
                           const Model& model, const TimeGrid& grid,
                           std::chrono::milliseconds compile_time);

}  // namespace desmo::load
