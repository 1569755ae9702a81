// `desmo_report check`.
#pragma once

#include <string>

namespace desmo::report {

struct CheckCommand {
  std::string file;      ///< results file of a check
  std::string baseline;  ///< results file to compare with; empty: the check holds both sides
  std::string format = "terminal";
  bool pending = false;  ///< only list what has still to be measured, "PASS CANDIDATE" a line
};

/// Prints the verdict, or what is pending, on standard output. Returns the exit code: that of the
/// CheckVerdict, or of CheckVerdict::pass after a list of what is pending;
/// CheckVerdict::invalid for a file that is no whole results file, CheckVerdict::incomparable for
/// one that mixes machines or is of an unknown version, 64 when it cannot be read, with a message.
/// Throws OutputError.
int run(const CheckCommand& command);

}  // namespace desmo::report
