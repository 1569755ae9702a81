#include "bench/kit/candidate.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <utility>

#include "bench/kit/memory.h"

namespace desmo::bench {

void Candidate::verify() {
  if (is_verified_ || refusal_) return;
  try {
    if (Checked wrong = check(verifying_run_))
      refuse(*std::move(wrong));
    else
      is_verified_ = true;
  } catch (const std::exception& e) {
    refuse(failed(e.what()));
  }
}

void Candidate::refuse(Refusal why) {
  refusal_ = std::move(why);
  is_verified_ = false;
  seconds_.clear();
}

void Candidate::measure(const std::function<void()>& measurement) {
  if (!is_verified_) return;
  try {
    measurement();
  } catch (const std::exception& e) {
    refuse(failed(e.what()));
  }
}

std::optional<double> Candidate::time_afresh() {
  double least = std::numeric_limits<double>::infinity();
  measure([&] {
    run_on_fresh_heap([&] {
      const Analysis analysis = make_analysis(windows_);
      const double begin = now(clock_);
      do {
        const double before = now(clock_);
        analysis();
        least = std::min(least, now(clock_) - before);
      } while (clock_ == Clock::wall && now(clock_) - begin < min_wall_seconds);
    });
  });
  return is_verified_ ? std::optional(least) : std::nullopt;
}

void Candidate::add_sample(double seconds) {
  if (is_verified_) seconds_.push_back(seconds);
}

}  // namespace desmo::bench
