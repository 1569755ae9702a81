#include "cases/mechanism/carriers.h"

#include <algorithm>

namespace desmo {

Carriers::Carriers(const Mechanism& mechanism, std::vector<int> Mechanism::Body::*carried) {
  for (int body = 0; body < static_cast<int>(mechanism.bodies.size()); ++body)
    for (const int entity : mechanism.bodies[body].*carried) pairs_.push_back({entity, body});
  std::ranges::sort(pairs_);
}

int Carriers::find(Pair pair) const {
  const auto found = std::ranges::lower_bound(pairs_, pair);
  return found != pairs_.end() && *found == pair ? static_cast<int>(found - pairs_.begin()) : -1;
}

std::span<const Carriers::Pair> Carriers::of(int entity) const {
  const auto begin = std::ranges::lower_bound(pairs_, entity, {}, &Pair::entity);
  const auto end = std::ranges::upper_bound(begin, pairs_.end(), entity, {}, &Pair::entity);
  return {begin, end};
}

}  // namespace desmo
