// Handling of SIGINT, SIGTERM and SIGHUP. They end the program, and a compiler that it runs, at
// once, and leave no unfinished file.
#pragma once

#include <string>

namespace desmo::cli {

/// Installs the signal handlers. A signal that was ignored from the start (nohup) stays ignored.
/// Writes to a closed pipe or beyond a size limit report errors themselves.
void handle_signals();

/// A file that an interruption removes while this object lives. Only one may exist at a time.
class RemovedWhenInterrupted {
 public:
  explicit RemovedWhenInterrupted(const std::string& path);
  RemovedWhenInterrupted(const RemovedWhenInterrupted&) = delete;
  RemovedWhenInterrupted& operator=(const RemovedWhenInterrupted&) = delete;
  ~RemovedWhenInterrupted();
};

}  // namespace desmo::cli
