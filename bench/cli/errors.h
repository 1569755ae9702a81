// What can end the program, and the exit code of each: the numbers of sysexits.h where it has one.
#pragma once

#include <stdexcept>
#include <string>

#include "cases/io/files.h"

namespace desmo::cli {

enum ExitCode {
  success = 0,
  not_solved = 1,         ///< the mechanism cannot be solved
  usage_error = 64,       ///< the command line
  bad_input = 65,         ///< what a file says
  unreadable_input = 66,  ///< there is no such file, or it cannot be read
  unavailable = 69,       ///< another program is missing or has failed
  internal_error = 70,
  unwritable_output = 74,
  output_closed = 141,  ///< nobody reads standard output any more: 128 + SIGPIPE
};

/// A message for people: "<file>: <place>: <what is wrong>; <remedy>", fit for a terminal.
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

/// The end of a pipe is gone. Not worth a message.
struct OutputClosed {};

/// Says on standard error what the exception being handled means to the user. Returns the exit
/// code; throws nothing.
int report_current_exception() noexcept;

}  // namespace desmo::cli
