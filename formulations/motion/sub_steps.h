#pragma once

#include <cmath>

namespace desmo {

/// Goes from one time to another in sub-steps, and returns whether `to` was reached.
/// - go(t): goes to time t; returns whether it could
/// - max_tries: largest number of calls of go
/// The first sub-step is half of the whole. A failed one is halved, down to 2⁻¹⁰ of the whole;
/// after a success the next is twice as long. Returns false where sub-steps would become shorter or
/// tries are used up. Returns false, too, where `from` or `to` is not finite, or no double lies
/// between two times.
template <class Go>
bool go_in_sub_steps(double from, double to, int max_tries, Go&& go) {
  if (!std::isfinite(to - from)) return false;  // halves of it would not end
  constexpr double min_sub_step = 0x1p-10;      // minimum length (≥), relative to the whole step
  double reached = from, sub_step = (to - from) / 2;
  for (int tries = 0; tries < max_tries; ++tries) {
    const bool is_last = !(std::abs(to - reached) > std::abs(sub_step));
    const double next = is_last ? to : reached + sub_step;
    if (go(next)) {
      if (is_last) return true;
      reached = next;
      sub_step *= 2;
    } else {
      sub_step = (next - reached) / 2;
      const double middle = reached + sub_step;
      if (middle == reached || middle == next) return false;  // no double lies between
      if (!(std::abs(sub_step) >= min_sub_step * std::abs(to - from))) return false;
    }
  }
  return false;
}

}  // namespace desmo
