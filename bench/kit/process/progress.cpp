#include "bench/kit/process/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace desmo::bench {

Progress::Progress(std::string what, double work, bool only_on_terminal)
    : what_(std::move(what)),
      all_(work),
      terminal_(isatty(STDERR_FILENO) == 1),
      only_there_(only_on_terminal) {}

Progress::~Progress() {
  clear();
  if (only_there_ || all_ == 0) return;
  std::fprintf(stderr, "%s: %.0f %% in %.0f s\n", what_.c_str(), 100 * done_ / all_, elapsed());
}

void Progress::add_done(double work) {
  const std::lock_guard lock(mutex_);
  done_ = std::min(all_, done_ + work);
  const double now = elapsed();
  if (now - shown_ < (terminal_ ? 0.2 : 10) || (only_there_ && !terminal_)) return;
  if (!terminal_ && done_ - shown_done_ < all_ / 10) return;
  shown_ = now;
  shown_done_ = done_;
  std::fprintf(stderr, "%s%s: %.0f %%, %.0f s left%s", terminal_ ? "\r" : "", what_.c_str(),
               100 * done_ / all_, std::ceil(now * (all_ - done_) / done_),
               terminal_ ? "\x1b[K" : "\n");
  std::fflush(stderr);
}

void Progress::clear() const {
  if (terminal_) std::fputs("\r\x1b[K", stderr);
}

double Progress::elapsed() const { return now(Clock::wall) - begin_; }

}  // namespace desmo::bench
