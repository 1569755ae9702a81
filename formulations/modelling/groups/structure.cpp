#include "formulations/modelling/groups/structure.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "formulations/modelling/groups/idle_freedoms.h"
#include "formulations/modelling/groups/matching.h"

namespace desmo {

namespace {

std::string names_of(const Mechanism& d, const RigidBodies& rigid, const std::vector<int>& list) {
  constexpr std::size_t shown = 8;
  std::string text;
  for (std::size_t i = 0; i < list.size() && i < shown; ++i)
    text += (i == 0 ? "'" : ", '") + d.bodies[rigid.list[list[i]].bodies.front()].name + "'";
  return list.size() > shown ? text + ", …" : text;
}

[[noreturn]] void refuse_undetermined(const Mechanism& d, const RigidBodies& rigid,
                                      const std::vector<int>& bodies, int missing) {
  std::string measured;
  for (const Mechanism::Coordinate& c : d.coordinates)
    if (!c.driven && std::ranges::any_of(bodies_related(rigid, c), [&](int b) {
          return std::ranges::binary_search(bodies, b);
        }))
      measured += (measured.empty() ? "'" : ", '") + c.name + "'";
  std::string spins;
  for (const int b : bodies)
    if (const std::string about = undetermined_spin(d, rigid, b); !about.empty())
      spins += "; '" + d.bodies[rigid.list[b].bodies.front()].name + "' is free to spin about " +
               about + ", which its other points do not follow";
  throw std::invalid_argument(
      d.name + " is under-constrained: " + std::to_string(missing) +
      (missing == 1 ? " freedom" : " freedoms") + " among " + names_of(d, rigid, bodies) +
      (missing == 1 ? " is" : " are") + " determined by no joint or driver" + spins +
      "; add a driver" +
      (measured.empty() ? " (declare a coordinate to drive)" : ", such as " + measured + ",") +
      " or a joint");
}

}  // namespace

Structure find_structure(const Mechanism& d, const RigidBodies& rigid) {
  if (rigid.list.size() == 1) throw std::invalid_argument(d.name + " has no body that moves");
  const std::vector<Restriction> all = find_restrictions(d, rigid);
  const Matching matching(rigid, all);
  if (const int missing = matching.undetermined(); missing > 0)
    refuse_undetermined(d, rigid, matching.undetermined_bodies(), missing);
  return order_groups(rigid, all, matching.components());
}

}  // namespace desmo
