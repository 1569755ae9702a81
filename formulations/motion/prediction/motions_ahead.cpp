#include "formulations/motion/prediction/motions_ahead.h"

#include <algorithm>
#include <utility>

namespace desmo {

int whole_lines(std::size_t numbers) {
  constexpr std::size_t line = lane_alignment / sizeof(double);
  return static_cast<int>(std::max<std::size_t>(1, (numbers + line - 1) / line) * line);
}

MotionsAhead::MotionsAhead(std::vector<const Motion*> motions)
    : of_row_(whole_lines(motions.size())),
      alone_(in_order(motions)),
      ahead_(in_order(std::move(motions)), together, in_rows(of_row_)) {
  samples_.resize((together + 1) * of_row_);
}

void MotionsAhead::expect(const TimeGrid& grid) {
  grid_ = grid;
  sampled_ = 0;
  next_ = together;
}

/// Samples the next eight instants of the grid. After its end, the last one is repeated.
void MotionsAhead::sample_next() {
  for (int k = 0; k < together; ++k)
    times_[k] = grid_.time(std::min(sampled_ + k, grid_.instants - 1));
  ahead_(times_, samples_.q.data(), samples_.qd.data(), samples_.qdd.data());
  sampled_ += together;
  next_ = 0;
}

MotionRow MotionsAhead::operator()(double t) {
  if (next_ == together && sampled_ < grid_.instants) sample_next();
  if (next_ < together && times_[next_] == t) return row(next_++);
  const std::size_t at = together * of_row_;
  alone_({&t, 1}, &samples_.q[at], &samples_.qd[at], &samples_.qdd[at]);
  return row(together);
}

}  // namespace desmo
