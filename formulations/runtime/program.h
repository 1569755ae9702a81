#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace desmo::load {

/// The end of another program.
struct ProgramEnd {
  bool good = false;   ///< exit code 0; true, too, when SIGCHLD is ignored and hides the code
  bool late = false;   ///< killed because its time was over
  std::string output;  ///< standard output and error, at most 64 KiB
};

/// Runs another program, without a shell, and waits for its end. Its environment is PATH, HOME and
/// TMPDIR of ours and LC_ALL=C; its standard input is empty. Throws std::system_error when it
/// cannot be started.
/// - arguments: the first is the program's file.
/// - folder: descriptor of its working directory.
/// - time: limit, after which it is killed with all processes of its group.
ProgramEnd run_program(const std::vector<std::string>& arguments, int folder,
                       std::chrono::milliseconds time);

/// Terminates the program that run_program() is running, if any, and all processes of its group.
/// May miss programs when several threads run some at once. May be called in a signal handler.
void end_running_program() noexcept;

}  // namespace desmo::load
