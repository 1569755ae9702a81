#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace desmo::regression {

/// How far a stage has come and how long it will still take, on standard error: one line,
/// rewritten, on a terminal; elsewhere a line every ten seconds. Any thread may report.
class Progress {
 public:
  /// What is counted, "rounds of 12 cells", and how many there are.
  Progress(std::string what, int all);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();  ///< says how long it took

  void one_done();

 private:
  using Clock = std::chrono::steady_clock;
  double elapsed() const;

  std::mutex mutex_;
  const std::string what_;
  const int all_;
  int done_ = 0;
  const bool terminal_;
  const Clock::time_point begin_ = Clock::now();
  double shown_ = 0;  // s after the beginning
};

}  // namespace desmo::regression
