#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace desmo::bench {

/// Seconds since it was made.
class Stopwatch {
 public:
  double elapsed() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin_ = Clock::now();
};

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

  double elapsed() const { return since_.elapsed(); }  ///< s

 private:
  void show(double seconds_left);

  std::mutex mutex_;
  const std::string what_;
  const int all_;
  int done_ = 0;
  const bool terminal_;
  const Stopwatch since_;
  double shown_ = 0;  // s after the beginning
};

}  // namespace desmo::bench
