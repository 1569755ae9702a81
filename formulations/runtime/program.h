#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace desmo::load {

/// How another program ended.
struct Ending {
  bool good = false;   ///< with exit code 0
  bool late = false;   ///< it was ended, because its time was over
  std::string output;  ///< what it wrote to standard output and error, at most 64 KiB
};

/// Runs another program, without a shell, and waits for its end. arguments: the first is the file
/// of the program. folder: the descriptor of the one that it works in. Of our environment it gets
/// PATH, HOME and TMPDIR, and LC_ALL=C beside; its standard input is empty. When the time is over,
/// it is killed with all that it has started. Throws std::system_error when it cannot be started.
Ending run_program(const std::vector<std::string>& arguments, int folder,
                   std::chrono::milliseconds time);

/// Ends the program that is being run, if any, and all that it has started. For signal handlers.
void end_running_program() noexcept;

}  // namespace desmo::load
