#include "bench/cli/progress.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace desmo::cli {

Progress::Progress(int instants, bool wanted)
    : all_(instants),
      shows_(wanted && ::isatty(STDERR_FILENO) == 1),
      begin_(Clock::now()),
      last_(begin_) {}

void Progress::solved(int instants) {
  if (!shows_) return;
  const Clock::time_point now = Clock::now();
  if (now - last_ < std::chrono::milliseconds(200)) return;
  last_ = now;
  const double elapsed = std::chrono::duration<double>(now - begin_).count();
  const double left = elapsed * (all_ - instants) / instants;
  std::fprintf(stderr, "\r%3d %%  %d of %d instants, %.0f s left\x1b[K",
               static_cast<int>(100.0 * instants / all_), instants, all_, std::ceil(left));
  std::fflush(stderr);
  on_screen_ = true;
}

void Progress::clear() {
  if (on_screen_) std::fputs("\r\x1b[K", stderr);
  on_screen_ = false;
}

}  // namespace desmo::cli
