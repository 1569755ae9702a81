// Progress of a run, shown on a terminal.
#pragma once

#include <chrono>

namespace desmo::cli {

/// Progress line on standard error, rewritten at most five times a second and removed in the end.
/// It is not shown when standard error is no terminal.
class Progress {
 public:
  Progress(int instants, bool wanted);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress() { clear(); }

  void solved(int instants);
  /// Removes the line, so that a message can be printed.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  int all_;
  bool shows_;
  bool on_screen_ = false;
  Clock::time_point begin_, last_;
};

}  // namespace desmo::cli
