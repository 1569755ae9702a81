#include "bench/experiments/accuracy/promise.h"

#include <algorithm>
#include <list>
#include <stdexcept>

namespace desmo::accuracy {

namespace {

constexpr double as_fast = 1.3;  // what a single sample may be off
constexpr std::size_t max_rivals = 24;
constexpr int rounds = 7;
constexpr double promise_sample = 5e-3;  // s

/// The fastest within the error on the begin of the motion, fastest first, as far as they may yet
/// be the best on all of it.
std::vector<std::string> rivals(const std::vector<Tried>& all, double allowed) {
  std::vector<std::string> found;
  double best = 0;
  for (const Tried& t : all) {  // fastest first
    if (!(t.error <= allowed / safety)) continue;
    if (found.empty()) best = t.seconds;
    if (found.size() == max_rivals || t.seconds > as_fast * best) break;
    found.push_back(t.id);
  }
  return found;
}

/// Whether a search may promise the error of what was compared.
bool holds(const Trial& trial, double allowed) {
  return trial.state == Trial::State::solved && trial.error.position.max <= allowed / safety;
}

Rival measured(const Trial& trial) {
  return {trial.id(), trial.error.position.max, trial.seconds_per_step};
}

}  // namespace

std::vector<Tried> everything(const TunedMotion& motion) {
  const TunedMotion begin{motion.begin, motion.begin};
  return search(begin, {Level::position, 1, 0}, {.exhaustive = true, .rounds = 1}).tried;
}

Promise promise(const TunedMotion& motion, const Problem& control, const std::vector<Tried>& all,
                double allowed, const Effort& effort) {
  const Found found = search(motion, {Level::position, allowed, 0}, effort);
  if (!found.choice) throw std::runtime_error("nothing holds the error");
  const std::string chosen = id_with(*found.choice->variant, found.choice->settings);
  std::list<Trial> trials;
  trials.emplace_back(control, *found.choice).compare();
  if (trials.front().state != Trial::State::solved)
    throw std::runtime_error(chosen + ": " + trials.front().message);
  for (const std::string& id : rivals(all, allowed)) {
    if (id == chosen) continue;
    trials.emplace_back(control, parse_id(id)).compare();
    if (!holds(trials.back(), allowed)) trials.pop_back();
  }
  for (int round = 0; round < rounds; ++round)
    for (Trial& t : trials) t.time(promise_sample);
  return {allowed, found.error.position.max, measured(trials.front()),
          measured(*std::ranges::min_element(trials, {}, &Trial::min_seconds))};
}

}  // namespace desmo::accuracy
