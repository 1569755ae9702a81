#include <array>

#include "cases/io/readers.h"
#include "cases/mechanism/names.h"

namespace desmo {
namespace {

using Coordinate = Mechanism::Coordinate;
using Type = Mechanism::CoordinateType;

void read_angle(const JsonValue& value, int dimension, const Names& names, Coordinate& c) {
  value.allow({"angle", "from", "towards", "estimate"});
  c.type = Type::angle;
  c.of = read_direction(value["angle"], names);
  if (dimension == 2) {
    if (const auto towards = value.find("towards"))
      towards->complain("is for space, this mechanism is plane; leave it out");
    if (const auto from = value.find("from")) c.from = read_direction(*from, names);
    return;
  }
  const auto given = value.find("from");
  if (!given || !value.find("towards") || !given->is_string())
    value.complain(
        "an angle in space needs the vectors where it is 0 and π/2; name them: \"from\": \"u\", "
        "\"towards\": \"v\"");
  const JsonValue from = *given, towards = value["towards"];
  std::string_view name = from.text();
  c.opposite = name.starts_with('-');
  if (c.opposite) name.remove_prefix(1);
  c.from.vector = names.vectors.find(from, name);
  if (towards.text().starts_with('-'))
    towards.complain(
        "an opposite such as " + in_quotes(towards.text()) +
        " is taken by \"from\" alone; give a vector that is declared in that direction");
  c.towards.vector = names.vectors.find(towards);
}

void read_distance(const JsonValue& value, const Names& names, Coordinate& c) {
  value.allow({"distance", "along", "estimate"});
  c.type = Type::distance;
  const auto [from, to] = names.points.find_pair(value["distance"]);
  c.of.from = from;
  c.of.to = to;
  const auto along = value.find("along");
  if (!along) return;
  c.type = Type::along;
  c.vector = names.vectors.find(*along);
}

void read_component(const JsonValue& value, int dimension, const Names& names, Coordinate& c) {
  value.allow({"component", "axis", "estimate"});
  c.type = Type::component;
  c.point = names.points.find(value["component"]);
  constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
  const JsonValue axis = value["axis"];
  c.axis = static_cast<int>(axis.choose("axis", axes));
  if (c.axis >= dimension)
    axis.complain("there is no z in the plane; give 'x' or 'y', or the mechanism dimension 3");
}

void read_drivers(const JsonValue& list, const Names& names, std::vector<Coordinate>& coordinates) {
  for (const JsonValue& value : list.elements()) {
    Coordinate& c = coordinates[names.coordinates.find(value)];
    if (c.driven) value.complain("names " + in_quotes(c.name) + " twice; name it once");
    c.driven = true;
  }
}

}  // namespace

Coordinate read_coordinate(const JsonValue& value, int dimension, const DisplayUnits& units,
                           const Names& names) {
  Coordinate c;
  c.name = checked_name(value, value.key());
  value.require_object(R"({"angle": ["A", "B"]})");
  value.allow({"angle", "distance", "component", "from", "towards", "along", "axis", "estimate"});
  const auto angle = value.find("angle"), distance = value.find("distance"),
             component = value.find("component");
  if (angle.has_value() + distance.has_value() + component.has_value() != 1)
    value.complain("must measure one thing; give angle, distance or component, one of them");
  if (angle) read_angle(value, dimension, names, c);
  if (distance) read_distance(value, names, c);
  if (component) read_component(value, dimension, names, c);
  if (const auto estimate = value.find("estimate"))
    c.estimate = estimate->number() * units.of(c.is_angle()).in_si;
  return c;
}

std::vector<Coordinate> read_coordinates(const JsonValue& root, int dimension,
                                         const DisplayUnits& units, Names& names) {
  std::vector<Coordinate> coordinates;
  if (const auto list = root.find("coordinates"))
    for (const JsonValue& value : list->members()) {
      coordinates.push_back(read_coordinate(value, dimension, units, names));
      names.coordinates.add(value.key());
    }
  if (const auto drivers = root.find("drivers")) read_drivers(*drivers, names, coordinates);
  return coordinates;
}

}  // namespace desmo
