#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "formulations/runtime/wanted_types.h"

namespace desmo::load {

// *Own kernels* are generated, compiled and loaded at run time for a user's mechanism. desmo was
// built without kernels for its part types.

/// The outcome of add_own_kernels.
struct OwnKernels {
  std::vector<TypeUse> types;    ///< part types that code was wanted for
  int parts_too_large = 0;       ///< number of parts too large for generated code
  bool compiled = false;         ///< compiled in this call, not found in the cache
  std::string compiler;          ///< its file and version
  std::string folder;            ///< folder of the cache
  double seconds = 0;            ///< total time [s]
  double seconds_compiling = 0;  ///< time of the compiler [s], included in `seconds`
  std::string problem;           ///< reason why there is no code for `types`; empty: there is
};

/// Adds kernels to the table for the part types of a formulation that it lacks. Loads them from
/// the user's cache, or generates and compiles them from samples of the motion over `grid`. Errors
/// are reported in the result and leave the table unchanged. compile_time: limit for the compiler.
/// The mechanism's names do not occur in the code; file names and arguments contain digests only.
OwnKernels add_own_kernels(KernelTable& table, const Variant& variant, const Settings& settings,
                           const Model& model, const TimeGrid& grid,
                           std::chrono::milliseconds compile_time);

}  // namespace desmo::load
