// Each part by the library that is fastest for its type.

#include "formulations/algebra/mixed.h"

#include <algorithm>
#include <cmath>

#include "formulations/algebra/step_seconds.h"
#include "formulations/part_type.h"

namespace desmo {

namespace {

constexpr double needed_gain = 0.05;

/// Beyond so many unknowns dense matrices are not tried. A step of theirs takes milliseconds there,
/// O(n³), and already beyond some 120 it takes longer than with UMFPACK, the slower of the sparse
/// LUs (bench/growth).
constexpr int largest_dense = 200;

/// Of parts with equal keys a step is the same work. Where iteration starts and ends is not: one
/// iteration more costs all backends alike.
std::string key(const PartContext& part) {
  return describe_type(part.mechanism, part.definition).fingerprint +
         (part.kernels ? " symbolic" : " automatic") +
         " jacobian:" + std::to_string(static_cast<int>(part.settings.jacobian)) +
         " factorisation:" + std::to_string(static_cast<int>(part.settings.factorisation));
}

/// Sparse ones first, so that dense ones are not chosen where they are only as fast: a part that is
/// measured has the caches to itself, and in a step n² numbers of each part compete for them.
std::vector<const Backend*> candidates(std::span<const Backend* const> backends, int unknowns) {
  std::vector<const Backend*> all(backends.begin(), backends.end());
  if (unknowns > largest_dense) std::erase_if(all, [](const Backend* b) { return b->dense; });
  // Nor are normal equations: measured where they are well conditioned, they would be used where
  // they are not.
  std::erase_if(all, [](const Backend* b) { return b->squares_condition; });
  std::ranges::stable_partition(all, [](const Backend* b) { return !b->dense; });
  return all;
}

const Backend& choose(const PartContext& part) {
  static BackendChoice choice(backends(), &step_seconds);
  return choice.of(part);
}

}  // namespace

std::size_t fastest(std::span<const double> seconds) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < seconds.size(); ++i)
    if (seconds[i] < (1 - needed_gain) * seconds[best]) best = i;
  return best;
}

const Backend& BackendChoice::of(const PartContext& part) {
  const std::lock_guard lock(mutex_);
  const std::string type = key(part);
  if (const auto known = chosen_.find(type); known != chosen_.end()) return *known->second;
  const auto tried = candidates(backends_, static_cast<int>(part.definition.unknowns.size()));
  const std::vector<double> seconds = measure_(part, tried);
  const std::size_t best = fastest(seconds);
  if (!std::isfinite(seconds[best])) return *tried[best];  // of this part nothing can be learnt
  return *(chosen_[type] = tried[best]);
}

const Backend mixed_backend{.name = "mixed",
                            .dense = false,
                            .make_solver = nullptr,  // the chosen one's
                            .version = [] { return std::string("of the others"); },
                            .choose = &choose};

}  // namespace desmo
