// SIGINT, SIGTERM and SIGHUP end the program at once, and a compiler that it runs, and leave no
// unfinished file.
#pragma once

#include <string>

namespace desmo::cli {

/// Sets up what signals do; a signal that was ignored from the start (nohup) stays ignored. A
/// write to a closed pipe or beyond a limit of size is reported by the write itself.
void handle_signals();

/// A file that an interruption removes while this object lives, if it exists. There can be one at
/// a time.
class RemovedWhenInterrupted {
 public:
  explicit RemovedWhenInterrupted(const std::string& path);
  RemovedWhenInterrupted(const RemovedWhenInterrupted&) = delete;
  RemovedWhenInterrupted& operator=(const RemovedWhenInterrupted&) = delete;
  ~RemovedWhenInterrupted();
};

}  // namespace desmo::cli
