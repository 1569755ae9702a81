#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <vector>

#include "cases/mechanism/checks.h"
#include "cases/mechanism/directions.h"
#include "cases/mechanism/names.h"
#include "cases/numbers/space.h"

namespace desmo {
namespace {

using Part = MechanismError::Part;

constexpr double unit_length_rounding = 1e-9;  // a vector has length 1 when |length − 1| ≤ this

bool finite(const Mechanism::Vec& x) {
  return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
}

bool is_unit(const Mechanism::Vec& u) {
  return std::abs(std::sqrt(dot(u, u)) - 1) <= unit_length_rounding;
}

template <class Entry>
void check_unique(const Mechanism& mechanism, Part part, const std::vector<Entry>& entries,
                  std::set<std::string_view>& taken, const char* among) {
  for (int i = 0; i < static_cast<int>(entries.size()); ++i) {
    const EntryRefusal refuse{mechanism, part, i};
    if (entries[i].name.empty()) refuse("has no name; give one");
    if (!taken.insert(entries[i].name).second)
      refuse(std::string("the name is given twice among ") + among + "; rename one");
  }
}

void check_points(const Mechanism& mechanism) {
  for (int i = 0; i < static_cast<int>(mechanism.points.size()); ++i) {
    const EntryRefusal refuse{mechanism, Part::point, i};
    const Mechanism::Vec& x = mechanism.points[i].position;
    if (!finite(x)) refuse("the position is not finite; give finite numbers");
    if (mechanism.dimension == 2 && x[2] != 0)
      refuse("has a third component that is not 0; in the plane it must be");
  }
}

void check_along(const Mechanism& mechanism, int i, const Carriers& points,
                 const Carriers& vectors) {
  const EntryRefusal refuse{mechanism, Part::vector, i};
  const auto [p, q] = *mechanism.vectors[i].along;
  if (!is_in(p, mechanism.points) || !is_in(q, mechanism.points))
    refuse("points along points that do not exist");
  if (!direction(mechanism.points[p].position, mechanism.points[q].position))
    refuse("points from " + in_quotes(mechanism.points[p].name) + " to " +
           in_quotes(mechanism.points[q].name) + ", which coincide; give them different positions");
  const auto carriers = vectors.of(i);
  const bool carried = std::ranges::any_of(carriers, [&, p = p, q = q](const Carriers::Pair& v) {
    return points.carries(v.body, p) && points.carries(v.body, q);
  });
  if (!carriers.empty() && !carried)
    refuse("no body that carries it carries " + in_quotes(mechanism.points[p].name) + " and " +
           in_quotes(mechanism.points[q].name) + "; add the points to the body");
}

void check_vectors(const Mechanism& mechanism) {
  for (int i = 0; i < static_cast<int>(mechanism.vectors.size()); ++i) {
    const EntryRefusal refuse{mechanism, Part::vector, i};
    const Mechanism::Vec& u = mechanism.vectors[i].direction;
    if (!is_unit(u)) refuse("is not of length 1; divide it by its length");
    if (mechanism.dimension == 2 && u[2] != 0)
      refuse("has a third component that is not 0; in the plane it must be");
  }
}

template <class Entry>
void check_carried(const Mechanism& mechanism, int body, std::vector<int> carried,
                   const std::vector<Entry>& entries, const char* kind) {
  const EntryRefusal refuse{mechanism, Part::body, body};
  for (const int entity : carried)
    if (!is_in(entity, entries)) refuse(std::string("carries a ") + kind + " that does not exist");
  std::ranges::sort(carried);
  const auto twice = std::ranges::adjacent_find(carried);
  if (twice != carried.end())
    refuse(std::string("lists the ") + kind + " " + in_quotes(entries[*twice].name) +
           " twice; list it once");
}

void check_length(const Mechanism& mechanism, int i) {
  const EntryRefusal refuse{mechanism, Part::body, i};
  const Mechanism::Body& body = mechanism.bodies[i];
  if (body.points.size() != 2)
    refuse("has a length but " + std::to_string(body.points.size()) +
           " points; a length is for a body of exactly two. Leave it out, and draw the points at "
           "their distances: more than two keep those of the nominal positions");
  if (!std::isfinite(body.length->value) || !(body.length->value > 0))
    refuse("the length is not above 0; give the distance of its two points");
  const Mechanism::Point &p = mechanism.points[body.points[0]],
                         &q = mechanism.points[body.points[1]];
  if (!direction(p.position, q.position))
    refuse("its points " + in_quotes(p.name) + " and " + in_quotes(q.name) +
           " coincide; estimate different positions");
}

void check_frame(const Mechanism& mechanism, int i) {
  const EntryRefusal refuse{mechanism, Part::body, i};
  const Mechanism::Body& body = mechanism.bodies[i];
  const Mechanism::Frame& own = *body.own;
  if (i == 0 || body.length)
    refuse("has a frame of its own and is the ground, or has a length; draw it");
  if (own.points.size() != body.points.size() || own.vectors.size() != body.vectors.size())
    refuse("has a frame of its own; give each point and vector in it");
  std::vector<Mechanism::Vec> all = shape_of(mechanism, body);
  all.push_back(own.origin);
  for (const Mechanism::ExactVec& x : own.vectors) {
    all.push_back(Mechanism::rounded(x));
    if (!is_unit(all.back()))
      refuse("has a vector in its frame that is not of length 1; divide it");
  }
  for (const Mechanism::Vec& x : all)
    if (!finite(x) || !finite(own.rotation) || (mechanism.dimension == 2 && x[2] != 0))
      refuse("has a frame with a number that is not finite or, in the plane, a third component");
}

// Refuses a moving body that carries two points or more and no vectors, when all its points
// coincide.
void check_extent(const Mechanism& mechanism, int i) {
  const Mechanism::Body& body = mechanism.bodies[i];
  if (i == 0 || body.points.size() < 2 || !body.vectors.empty()) return;
  const std::vector<Mechanism::Vec> points = shape_of(mechanism, body);
  for (const Mechanism::Vec& p : points)
    if (direction(points.front(), p)) return;
  const EntryRefusal refuse{mechanism, Part::body, i};
  refuse("all its points coincide, a link of zero length; move them apart");
}

}  // namespace

Mechanism::Vec carried_vector(const Mechanism& mechanism, int body, int vector) {
  const Mechanism::Body& b = mechanism.bodies[body];
  if (!b.own) return mechanism.vectors[vector].direction;
  const auto k = std::ranges::find(b.vectors, vector) - b.vectors.begin();
  return Mechanism::rounded(b.own->vectors[k]);
}

void check_names(const Mechanism& mechanism) {
  std::set<std::string_view> bodies, joints, couplings, quantities;
  check_unique(mechanism, Part::body, mechanism.bodies, bodies,
               "the bodies (the first is the ground)");
  check_unique(mechanism, Part::joint, mechanism.joints, joints, "the joints");
  check_unique(mechanism, Part::coupling, mechanism.couplings, couplings, "the couplings");
  const char* const among = "the points, vectors and coordinates";
  check_unique(mechanism, Part::point, mechanism.points, quantities, among);
  check_unique(mechanism, Part::vector, mechanism.vectors, quantities, among);
  check_unique(mechanism, Part::coordinate, mechanism.coordinates, quantities, among);
}

void check_entities(const Mechanism& mechanism) {
  check_points(mechanism);
  check_vectors(mechanism);
  for (int i = 0; i < static_cast<int>(mechanism.bodies.size()); ++i) {
    check_carried(mechanism, i, mechanism.bodies[i].points, mechanism.points, "point");
    check_carried(mechanism, i, mechanism.bodies[i].vectors, mechanism.vectors, "vector");
    if (mechanism.bodies[i].own) check_frame(mechanism, i);
    if (mechanism.bodies[i].length) check_length(mechanism, i);
    check_extent(mechanism, i);
  }
}

void check_vectors_along(const Mechanism& mechanism, const Carriers& points,
                         const Carriers& vectors) {
  for (int i = 0; i < static_cast<int>(mechanism.vectors.size()); ++i)
    if (mechanism.vectors[i].along) check_along(mechanism, i, points, vectors);
}

}  // namespace desmo
