#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace desmo::suite {

/// How far something has come and how long it will still take, on standard error: one line,
/// rewritten, on a terminal; elsewhere a line every ten seconds. Any thread may report.
class Progress {
 public:
  /// What is counted, "rounds of 12 cells", and how many there are.
  Progress(std::string what, int all);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();  ///< says how long it took

  /// Of equal ones, so that what is left takes as long as what is done did.
  void one_done();
  /// So many more seconds are expected.
  void one_done(double seconds_left);
  /// Makes room on a terminal for other output.
  void clear();

  double elapsed() const;  ///< s

 private:
  using Clock = std::chrono::steady_clock;
  void show(double seconds_left);

  std::mutex mutex_;
  const std::string what_;
  const int all_;
  int done_ = 0;
  const bool terminal_;
  const Clock::time_point begin_ = Clock::now();
  double shown_ = 0;  // s after the beginning
};

}  // namespace desmo::suite
