#include "cases/mechanism/checks.h"
#include "cases/mechanism/mechanism.h"
#include "cases/mechanism/names.h"

namespace desmo {

using Part = MechanismError::Part;

void refuse(const Mechanism& d, Part part, int index, const std::string& what) {
  const auto named = [&](const char* kind, const std::string& name) {
    return MechanismError(part, index, std::string(kind) + " " + in_quotes(name) + ": " + what);
  };
  switch (part) {
    case Part::point:
      throw named("point", d.points[index].name);
    case Part::vector:
      throw named("vector", d.vectors[index].name);
    case Part::body:
      throw named("body", d.bodies[index].name);
    case Part::joint:
      throw named("joint", d.joints[index].name);
    case Part::coordinate:
      throw named("coordinate", d.coordinates[index].name);
    case Part::description:
      break;
  }
  throw named("mechanism", d.name);
}

void validate(const Mechanism& d) {
  if (d.dimension != 2 && d.dimension != 3)
    refuse(d, Part::description, 0,
           "the dimension is " + std::to_string(d.dimension) + "; it must be 2 or 3");
  if (d.bodies.empty())
    refuse(d, Part::description, 0, "has no bodies; the first body must be the ground");
  check_names(d);
  check_entities(d);
  const Carriers points(d, &Mechanism::Body::points), vectors(d, &Mechanism::Body::vectors);
  check_vectors_along(d, points, vectors);
  check_joints(d, points, vectors);
  check_sharing(d, points, vectors);
  check_coordinates(d, points, vectors);
}

}  // namespace desmo
