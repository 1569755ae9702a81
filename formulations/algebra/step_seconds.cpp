// What a step of a part costs with each library.

#include "formulations/algebra/step_seconds.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

namespace desmo {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Between the three of the paper's guess and the one of a good guess.
constexpr int iterations = 2;

constexpr double most_steps = 1e6;  // of a sample, should the clock stand still
constexpr double sample = 20e-6;    // s, hundreds of times what reading the clock takes
constexpr int rounds = 15;
constexpr int least_rounds = 3;  // one sample alone may have been disturbed
constexpr double hopeless = 2;   // times the fastest

/// The mechanism as estimated, and everything in motion: what is multiplied by zero may cost less.
State estimated(const Mechanism& m) {
  State s;
  s.q = m.estimate;
  s.q.insert(s.q.end(), m.fixed_values.begin(), m.fixed_values.end());
  for (std::vector<double>* rates : {&s.qd, &s.qdd}) {
    rates->assign(m.estimate.size(), 1);
    rates->resize(s.q.size());
  }
  return s;
}

/// A part with one of the backends.
class Trial {
 public:
  Trial(const PartContext& part, const Backend& backend, const State& start)
      : unknowns_(part.definition.unknowns), start_(start), state_(start) {
    try {
      part_ = backend.make_part(part);
    } catch (const std::invalid_argument&) {
      return;  // it cannot be analysed by this library
    }
    if (!steps(1)) part_.reset();  // where memory is touched and pivots are chosen
  }

  double least() const { return least_; }

  void take_sample() {
    if (!part_) return;
    const auto begin = std::chrono::steady_clock::now();
    const bool solved = steps(steps_);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
    least_ = solved ? std::min(least_, spent.count() / steps_) : infinity;
    if (!solved) part_.reset();
    if (least_ * steps_ < sample)
      steps_ = static_cast<int>(std::ceil(std::min(sample / least_, most_steps)));
  }

 private:
  bool steps(int count) {
    bool solved = true;
    for (int i = 0; i < count; ++i) {
      for (const int u : unknowns_) state_.q[u] = start_.q[u];
      solved &= part_->solve(state_, start_.q, Level::acceleration).status == Status::converged;
    }
    return solved;
  }

  const std::vector<int>& unknowns_;
  const State& start_;
  State state_;
  std::unique_ptr<Part> part_;  // null: of no use
  int steps_ = 1;               // of a sample
  double least_ = infinity;
};

}  // namespace

std::vector<double> step_seconds(const PartContext& part,
                                 std::span<const Backend* const> backends) {
  PartContext tried = part;
  tried.profile = nullptr;
  tried.settings.fixed_iterations = iterations;
  const State start = estimated(part.mechanism);
  std::vector<Trial> trials;
  trials.reserve(backends.size());
  for (const Backend* backend : backends) trials.emplace_back(tried, *backend, start);

  double best = infinity;
  for (int round = 0; round < rounds; ++round)
    for (Trial& trial : trials) {
      if (round >= least_rounds && !(trial.least() < hopeless * best)) continue;
      trial.take_sample();
      best = std::min(best, trial.least());
    }
  std::vector<double> seconds;
  for (const Trial& trial : trials) seconds.push_back(trial.least());
  return seconds;
}

}  // namespace desmo
