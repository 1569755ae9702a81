#include "bench/kit/process/progress.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace desmo::bench {

Progress::Progress(std::string what, int all)
    : what_(std::move(what)), all_(all), terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  clear();
  std::fprintf(stderr, "%d of %d %s in %.0f s\n", done_, all_, what_.c_str(), elapsed());
}

void Progress::one_done() {
  const std::lock_guard lock(mutex_);
  ++done_;
  show(elapsed() * (all_ - done_) / done_);
}

void Progress::one_done(double seconds_left) {
  const std::lock_guard lock(mutex_);
  ++done_;
  show(seconds_left);
}

void Progress::show(double seconds_left) {
  const double now = elapsed();
  if (now - shown_ < (terminal_ ? 0.2 : 10)) return;
  shown_ = now;
  std::fprintf(stderr, "%s%d of %d %s, %.0f s left%s", terminal_ ? "\r" : "", done_, all_,
               what_.c_str(), std::ceil(seconds_left), terminal_ ? "\x1b[K" : "\n");
  std::fflush(stderr);
}

void Progress::clear() {
  if (terminal_) std::fputs("\r\x1b[K", stderr);
}

}  // namespace desmo::bench
