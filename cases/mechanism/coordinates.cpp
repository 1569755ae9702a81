#include <algorithm>
#include <cmath>

#include "cases/mechanism/checks.h"
#include "cases/mechanism/directions.h"
#include "cases/mechanism/names.h"
#include "cases/numbers/space.h"

namespace desmo {
namespace {

/// Directions are at a right angle when |cosine of their angle| ≤ right_angle.
constexpr double right_angle = 1e-6;

bool is_same_line(const Mechanism::Direction& a, const Mechanism::Direction& b) {
  if (!a.is_given() || a.is_line() != b.is_line()) return false;
  if (!a.is_line()) return a.vector == b.vector;
  return std::minmax(a.from, a.to) == std::minmax(b.from, b.to);
}

class CoordinateCheck {
 public:
  CoordinateCheck(const Mechanism& mechanism, const Carriers& points, const Carriers& vectors,
                  int index)
      : refuse_{mechanism, MechanismError::Part::coordinate, index},
        mechanism_(mechanism),
        points_(points),
        vectors_(vectors),
        c_(mechanism.coordinates[index]) {}

  void run() const {
    using enum Mechanism::CoordinateType;
    if (c_.estimate && !std::isfinite(*c_.estimate))
      refuse_("the estimate is not finite; give a finite number");
    switch (c_.type) {
      case angle:
        return check_angle();
      case distance:
        return check_line(c_.of);
      case along:
        check_line(c_.of);
        return check_vector(c_.vector);
      case component:
        check_point(c_.point);
        if (c_.axis < 0 || c_.axis >= mechanism_.dimension)
          refuse_("has an axis beyond the mechanism's dimension; choose one of its axes");
        return;
    }
    refuse_("has a type that does not exist");
  }

 private:
  template <class Entity>
  void check_carried(int i, const std::vector<Entity>& entities, const Carriers& carriers,
                     const std::string& kind) const {
    if (!is_in(i, entities)) refuse_("refers to a " + kind + " that does not exist");
    if (!carriers.is_carried(i))
      refuse_("the " + kind + " " + in_quotes(entities[i].name) +
              " is carried by no body; list it in one");
  }

  void check_point(int point) const { check_carried(point, mechanism_.points, points_, "point"); }
  void check_vector(int vector) const {
    check_carried(vector, mechanism_.vectors, vectors_, "vector");
  }

  void check_line(const Mechanism::Direction& line) const {
    check_point(line.from);
    check_point(line.to);
    if (line.from == line.to)
      refuse_("its two points are both " + in_quotes(mechanism_.points[line.from].name) +
              "; name two different ones");
  }

  Mechanism::Vec check_direction(const Mechanism::Direction& of) const {
    if (!of.is_line()) {
      check_vector(of.vector);
      return mechanism_.vectors[of.vector].direction;
    }
    check_line(of);
    const Mechanism::Point &from = mechanism_.points[of.from], &to = mechanism_.points[of.to];
    const auto unit = direction(from.position, to.position);
    if (!unit)
      refuse_("the points " + in_quotes(from.name) + " and " + in_quotes(to.name) +
              " coincide and have no direction; give them different positions");
    return *unit;
  }

  void check_apart(const Mechanism::Direction& other) const {
    if (is_same_line(c_.of, other))
      refuse_("is an angle between a direction and itself, which never changes; name two");
  }

  void check_angle() const {
    const Mechanism::Vec w = check_direction(c_.of);
    check_apart(c_.from);
    check_apart(c_.towards);
    if (mechanism_.dimension == 2) {
      if (c_.towards.is_given())
        refuse_("is towards a direction, which is for space only; leave that out");
      if (c_.from.is_given()) check_direction(c_.from);
      return;
    }
    if (!c_.from.is_given() || !c_.towards.is_given())
      refuse_("an angle in space needs the directions where it is 0 and π/2; give both");
    if (c_.from.is_line() || c_.towards.is_line())
      refuse_("the directions where it is 0 and π/2 must be vectors in space; declare vectors");
    const Mechanism::Vec u = check_direction(c_.from), v = check_direction(c_.towards);
    if (std::abs(cosine(c_.from.vector, c_.towards.vector)) > right_angle)
      refuse_("the directions where it is 0 and π/2 are not at a right angle; choose another");
    if (std::hypot(dot(w, u), dot(w, v)) <= right_angle)
      refuse_(text(c_.of) + " is perpendicular to the plane of " + text(c_.from) + " and " +
              text(c_.towards) +
              ", where its projection vanishes and has no angle; choose another direction");
  }

  // Returns the cosine of the angle between two vectors. If a body with a frame of its own carries
  // both, they are taken from that frame, otherwise as drawn.
  double cosine(int u, int v) const {
    int carrier = 0;
    for (const auto& [vector, body] : vectors_.of(u))
      if (mechanism_.bodies[body].own && vectors_.carries(body, v)) carrier = body;
    return dot(carried_vector(mechanism_, carrier, u), carried_vector(mechanism_, carrier, v));
  }

  std::string text(const Mechanism::Direction& of) const {
    if (!of.is_line()) return in_quotes(mechanism_.vectors[of.vector].name);
    return "the line from " + in_quotes(mechanism_.points[of.from].name) + " to " +
           in_quotes(mechanism_.points[of.to].name);
  }

  const EntryRefusal refuse_;
  const Mechanism& mechanism_;
  const Carriers &points_, &vectors_;
  const Mechanism::Coordinate& c_;
};

}  // namespace

void check_coordinates(const Mechanism& mechanism, const Carriers& points,
                       const Carriers& vectors) {
  for (int i = 0; i < static_cast<int>(mechanism.coordinates.size()); ++i)
    CoordinateCheck(mechanism, points, vectors, i).run();
}

}  // namespace desmo
