#include "bench/kit/candidate.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <utility>

#include "bench/kit/memory.h"

namespace desmo::bench {

VerifiedCandidate::VerifiedCandidate(Key, Candidate& candidate)
    : candidate_(candidate), windows_(candidate.grid().instants, candidate.clock()) {}

double VerifiedCandidate::time_afresh() {
  const Clock clock = candidate_.clock();
  double least = std::numeric_limits<double>::infinity();
  run_on_fresh_heap([&] {
    const Analysis analysis = candidate_.make_analysis(windows_);
    const double begin = now(clock);
    do {
      const double before = now(clock);
      analysis();
      least = std::min(least, now(clock) - before);
    } while (clock == Clock::wall && now(clock) - begin < min_wall_seconds);
  });
  return least;
}

void Candidate::verify() {
  if (!std::holds_alternative<Unverified>(state_)) return;
  try {
    if (Checked wrong = check(verifying_run_))
      refuse(*std::move(wrong));
    else
      state_.emplace<VerifiedCandidate>(VerifiedCandidate::Key(), *this);
  } catch (const std::exception& e) {
    refuse(failed(e.what()));
  }
}

void Candidate::measure(const std::function<void(VerifiedCandidate&)>& measurement) {
  auto* const verified = std::get_if<VerifiedCandidate>(&state_);
  if (!verified) return;
  try {
    measurement(*verified);
  } catch (const std::exception& e) {
    refuse(failed(e.what()));
  }
}

void Candidate::add_to(nlohmann::ordered_json&) const {}

std::string Candidate::message() const {
  const auto* const refusal = std::get_if<Refusal>(&state_);
  return refusal ? refusal->reason : "";
}

bool Candidate::is_refused(Refusal::Kind kind) const {
  const auto* const refusal = std::get_if<Refusal>(&state_);
  return refusal && refusal->kind == kind;
}

}  // namespace desmo::bench
