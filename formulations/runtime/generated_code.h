#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "cases/mechanism/motion.h"
#include "formulations/model/model.h"
#include "formulations/variants.h"

namespace desmo {

/// The parts of one type in a formulation.
struct TypeUse {
  std::string group;  ///< first group with such a part
  int unknowns = 0;   ///< unknowns of one part
  int parts = 0;      ///< number of parts that code was wanted for
};

/// The outcome of generating code.
struct GenerationOutcome {
  std::vector<TypeUse> types;    ///< part types that code was wanted for
  int parts_too_large = 0;       ///< number of parts too large for generated code
  bool compiled = false;         ///< compiled in this call, not found in the cache
  std::string compiler;          ///< its file and version; empty: not needed or not found
  std::string folder;            ///< folder of the cache; empty: not opened
  double seconds = 0;            ///< total time [s]
  double seconds_compiling = 0;  ///< time of the compiler [s], included in `seconds`
  std::string problem;           ///< reason why there is no code for `types`; empty: there is
};

/// Code that was generated for a mechanism, compiled and loaded:
///
///   const Configuration c = parse_id("group_symbolic_explicit/guess:hermite5");
///   const GeneratedCode code = generate_code(*c.variant, c.settings, model, scene.grid);
///   if (!code.problem.empty()) std::fprintf(stderr, "%s\n", code.problem.c_str());
///   const auto f = make_formulation(*c.variant, model, c.settings, *code.table);
struct GeneratedCode : GenerationOutcome {
  /// The code, and what desmo was built with; never null. It must outlive the formulations that are
  /// made with it.
  std::shared_ptr<const KernelTable> table;
};

/// Generates the code that a formulation needs for a model and that desmo was built without. Loads
/// it from the user's cache, or compiles it. Errors are reported in the result: the table is then
/// what desmo was built with. Names of the mechanism occur neither in the code nor in file names.
/// - grid: time grid of a typical motion, at whose states pivots are chosen
/// - compile_time: limit for the compiler
[[nodiscard]] GeneratedCode generate_code(
    const Variant& variant, const Settings& settings, const Model& model, const TimeGrid& grid,
    std::chrono::milliseconds compile_time = std::chrono::seconds(60));

}  // namespace desmo
