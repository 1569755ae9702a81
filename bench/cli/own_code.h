// Generated code for mechanisms that the program was not built with.
#pragma once

#include <CLI/CLI.hpp>

#include "formulations/equations/kernel_table.h"
#include "formulations/id.h"
#include "formulations/runtime/own_kernels.h"

namespace desmo::cli {

/// Options of code generation.
struct GenerationOptions {
  bool none = false;          ///< generate and load no code
  double compile_limit = 60;  ///< time that a compiler may take [s]
};

/// Adds the options that set `wanted`, which must outlive the command.
void add_options(CLI::App& command, GenerationOptions& wanted);

/// Generates and loads the code that a formulation needs and the program lacks, and adds it to the
/// table; where that fails, the table stays as it is. Does nothing if wanted.none. Unless quiet,
/// reports the result on standard error.
void add_missing_code(KernelTable& table, const Configuration& formulation, const Model& model,
                      const TimeGrid& grid, const GenerationOptions& wanted, bool quiet);

}  // namespace desmo::cli
