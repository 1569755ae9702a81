// The option --check: what of a run is proven.
#pragma once

#include <CLI/CLI.hpp>

#include "formulations/verification/run/checked_run.h"

namespace desmo::cli {

/// Adds --check to a command. Sets the mode, and N of sample:N.
CLI::Option* add_check(CLI::App& command, CheckOptions& options);

}  // namespace desmo::cli
