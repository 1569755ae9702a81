#pragma once

#include <mutex>
#include <string>

#include "bench/kit/time/clock.h"

namespace desmo::bench {

/// A progress line on standard error, with the expected remaining time: rewritten on a terminal;
/// elsewhere a new one when both ten seconds and a tenth of the work have passed. The last says how
/// long all took. Any thread may call add_done().
class Progress {
 public:
  /// what: for people, "rounds of 12 candidates". work: all there is to do, in any unit.
  /// only_on_terminal: nothing is said elsewhere, nor how long it took.
  Progress(std::string what, double work, bool only_on_terminal = false);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// Adds work that is done. The rest is expected to take as long by its amount.
  void add_done(double work = 1);
  /// Clears the line on a terminal, for other output.
  void clear() const;

 private:
  double elapsed() const;  ///< [s]

  std::mutex mutex_;
  const std::string what_;
  const double all_;
  double done_ = 0;
  const bool terminal_, only_there_;
  const double begin_ = now(Clock::wall);
  double shown_ = 0, shown_done_ = 0;  // s after the beginning, and the work then done
};

}  // namespace desmo::bench
