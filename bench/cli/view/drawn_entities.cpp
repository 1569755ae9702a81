#include "bench/cli/view/drawn_entities.h"

#include <algorithm>

namespace desmo::cli {

std::vector<bool> carried_points(const Mechanism& mechanism) {
  std::vector<bool> carried(mechanism.points.size());
  for (const Mechanism::Body& body : mechanism.bodies)
    for (const int p : body.points) carried[p] = true;
  return carried;
}

std::vector<bool> drawn_vectors(const Mechanism& mechanism) {
  std::vector<bool> drawn(mechanism.vectors.size());
  for (const Mechanism::Joint& joint : mechanism.joints)
    for (const int v : joint.vectors) drawn[v] = true;
  for (const Mechanism::Coordinate& c : mechanism.coordinates)
    for (const int v : {c.of.vector, c.from.vector, c.vector})
      if (c.driven && v >= 0) drawn[v] = true;
  return drawn;
}

std::size_t drawn_numbers(const Mechanism& mechanism) {
  const auto count = [](const std::vector<bool>& list) {
    return static_cast<std::size_t>(std::ranges::count(list, true));
  };
  return 1 + static_cast<std::size_t>(mechanism.dimension) *
                 (3 * count(carried_points(mechanism)) + count(drawn_vectors(mechanism)));
}

}  // namespace desmo::cli
