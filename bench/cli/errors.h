// Errors that end the program, and their exit codes, from sysexits.h where it has one.
#pragma once

#include <stdexcept>
#include <string>

#include "cases/io/files.h"

namespace desmo::cli {

enum ExitCode {
  success = 0,
  not_solved = 1,         ///< the mechanism cannot be solved
  usage_error = 64,       ///< wrong command line
  bad_input = 65,         ///< wrong content of a file
  unreadable_input = 66,  ///< file missing or not readable
  unavailable = 69,       ///< the page of `view` was not built
  internal_error = 70,
  unwritable_output = 74,
  output_closed = 141,  ///< standard output was closed by its reader: 128 + SIGPIPE
};

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
