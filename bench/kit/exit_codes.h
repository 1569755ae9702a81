#pragma once

namespace desmo::bench {

/// Exit codes of the programs of bench/. Codes from 64 on are those of sysexits.h, where that has a
/// fitting one.
/// The pages on the programs (bench/README.md, bench/cli/README.md) list them for users.
enum ExitCode {
  success = 0,
  not_solved = 1,         ///< the mechanism cannot be solved, or something measured is wrong
  usage_error = 64,       ///< wrong command line
  bad_input = 65,         ///< wrong content of a file
  unreadable_input = 66,  ///< file missing or not readable
  unavailable = 69,       ///< the page of `desmo view` was not built
  internal_error = 70,
  not_completed = 74,   ///< output cannot be written, or something cannot be measured
  output_closed = 141,  ///< standard output was closed by its reader: 128 + SIGPIPE
};

}  // namespace desmo::bench
