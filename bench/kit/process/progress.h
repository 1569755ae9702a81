#pragma once

#include <mutex>
#include <string>

#include "bench/kit/time/clock.h"

namespace desmo::bench {

/// A progress line on standard error, with the expected remaining time. On a terminal it is
/// rewritten. Elsewhere a new line is written when both ten seconds and a tenth of the work have
/// passed. The destructor writes a last line, with the time that all took. Any thread may call
/// add_done().
class Progress {
 public:
  /// - what: name of the work for people, "rounds of 12 candidates"
  /// - work: all there is to do, in any unit
  /// - only_on_terminal: writes nothing elsewhere, and no last line
  Progress(std::string what, double work, bool only_on_terminal = false);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// Adds work that is done. The expected time assumes that the rest takes as long per unit of
  /// work.
  void add_done(double work = 1);
  /// Clears the line on a terminal, for other output.
  void clear() const;

 private:
  double elapsed() const;  ///< wall-clock time since construction [s]

  std::mutex mutex_;
  const std::string what_;
  const double all_;
  double done_ = 0;
  const bool terminal_, only_there_;
  const double begin_ = now(Clock::wall);
  double shown_ = 0, shown_done_ = 0;  // elapsed() [s] and work done when a line was last written
};

}  // namespace desmo::bench
