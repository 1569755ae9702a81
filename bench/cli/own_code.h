// Code for formulations of mechanisms that the program does not know.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "formulations/equations/kernel_table.h"
#include "formulations/id.h"
#include "formulations/runtime/own_kernels.h"

namespace desmo::cli {

/// What a user says about it.
struct OwnCode {
  bool none = false;
  double compile_limit = 60;  // s
};

/// Adds the options that set it, which must outlive the command.
void add_options(CLI::App& command, OwnCode& wanted);

/// Adds to the table what a formulation needs that the program does not bring; unless quiet, says
/// on standard error what became of it.
void add_own_code(KernelTable& table, const Configuration& formulation, const Model& model,
                  const TimeGrid& grid, const OwnCode& wanted, bool quiet);

/// What was generated for a formulation and how long it took, or why it was not; empty when it
/// needed nothing beside what the program brings.
std::string note_on(const load::OwnKernels& own);

}  // namespace desmo::cli
