#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "cases/mechanism/motion.h"
#include "formulations/equations/kernel_table.h"
#include "formulations/model/model.h"
#include "formulations/variants.h"

namespace desmo::load {

/// Where parts of a type are.
struct TypeUse {
  std::string group;  ///< the first that has one
  int unknowns = 0;
  int parts = 0;
};

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

namespace desmo {

/// Code that was generated for a mechanism, compiled and loaded:
///
///   const Configuration c = parse_id("group_symbolic_explicit/guess:hermite5");
///   const GeneratedCode code = generate_code(*c.variant, c.settings, model, scene.grid);
///   if (!code.problem.empty()) std::fprintf(stderr, "%s\n", code.problem.c_str());
///   const auto f = make_formulation(*c.variant, model, c.settings, nullptr, code.table.get());
struct GeneratedCode : load::OwnKernels {
  /// The code, and what desmo was built with. It outlives the formulations that are made with it.
  std::shared_ptr<const KernelTable> table;
};

/// Generates the code that a formulation needs for a model, as the program desmo does; see
/// load::add_own_kernels. grid: of a motion that is typical, which decides pivots.
GeneratedCode generate_code(const Variant& variant, const Settings& settings, const Model& model,
                            const TimeGrid& grid,
                            std::chrono::milliseconds compile_time = std::chrono::seconds(60));

}  // namespace desmo
