#include "bench/kit/candidate.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <utility>

#include "bench/kit/memory.h"

namespace desmo::bench {

void Candidate::verify() {
  if (state_ != State::unverified) return;
  try {
    check(verifying_run_);
    state_ = State::verified;
  } catch (const NotRun& e) {
    leave_out(e.what());
  } catch (const std::exception& e) {
    end(State::failed, e.what());
  }
}

void Candidate::measure(const std::function<void()>& work) {
  if (!is_verified()) return;
  try {
    work();
  } catch (const std::exception& e) {
    end(State::failed, e.what());
  }
}

std::optional<double> Candidate::time_afresh() {
  double least = std::numeric_limits<double>::infinity();
  measure([&] {
    on_fresh_heap([&] {
      const Analysis analysis = make_analysis(windows_);
      const double begin = now(clock_);
      do {
        const double before = now(clock_);
        analysis();
        least = std::min(least, now(clock_) - before);
      } while (clock_ == Clock::wall && now(clock_) - begin < min_wall_seconds);
    });
  });
  return is_verified() ? std::optional(least) : std::nullopt;
}

void Candidate::add_sample(double seconds) {
  if (is_verified()) seconds_.push_back(seconds);
}

void Candidate::add_to(nlohmann::ordered_json&) const {}

void Candidate::end(State state, std::string why) {
  state_ = state;
  message_ = std::move(why);
}

}  // namespace desmo::bench
