// Errors that end the program, with their exit codes.
#pragma once

#include <stdexcept>
#include <string>

#include "bench/kit/exit_codes.h"
#include "cases/io/files.h"

namespace desmo::cli {

using bench::ExitCode;
using enum bench::ExitCode;

/// Error with a message for people, safe on terminals: "<file>: <place>: <what is wrong>;
/// <remedy>".
class CommandError : public std::runtime_error {
 public:
  CommandError(ExitCode code, const std::string& message)
      : std::runtime_error(message), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

/// Reports the exception being handled on standard error. Returns the exit code; throws nothing.
int report_current_exception() noexcept;

}  // namespace desmo::cli
