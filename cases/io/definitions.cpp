#include <functional>
#include <set>
#include <utility>

#include "cases/io/readers.h"
#include "cases/mechanism/checks.h"
#include "cases/mechanism/names.h"

namespace desmo {
namespace {

/// Reader of the points and coordinates that a request defines, which adds them to a mechanism.
/// Points come first, since coordinates may measure them.
class Definitions {
 public:
  Definitions(const FileUnits& units, Mechanism& mechanism) : units_(units), mechanism_(mechanism) {
    for (const Mechanism::Body& body : mechanism_.bodies) names_.bodies.add(body.name);
    const auto take = [&](const auto& entries) {
      for (const auto& entry : entries) taken_.insert(entry.name);
    };
    take(mechanism_.points), take(mechanism_.vectors), take(mechanism_.coordinates);
  }

  void add(const std::vector<JsonValue>& entries) {
    const std::size_t points = mechanism_.points.size(),
                      coordinates = mechanism_.coordinates.size();
    std::vector<JsonValue> point_places, coordinate_places;
    for_each(entries, "points", [&](const JsonValue& value) {
      add_point(value);
      point_places.push_back(value);
    });
    for (const Mechanism::Point& p : mechanism_.points) names_.points.add(p.name);
    for (const Mechanism::Vector& v : mechanism_.vectors) names_.vectors.add(v.name);
    std::vector<Mechanism::Coordinate> defined;
    for (const char* key : {"angles", "distances"})
      for_each(entries, key, [&](const JsonValue& value) {
        defined.push_back(read(value, key));
        coordinate_places.push_back(value);
      });
    mechanism_.coordinates.insert(mechanism_.coordinates.end(), defined.begin(), defined.end());
    if (point_places.empty() && coordinate_places.empty()) return;
    try {
      validate(mechanism_);
    } catch (const MechanismError& error) {
      // A definition is at fault, since the mechanism was valid without them. The error names it,
      // or the body that carries it.
      using Part = MechanismError::Part;
      const auto index = static_cast<std::size_t>(error.index());
      if (error.part() == Part::coordinate)
        coordinate_places.at(index - coordinates).complain(error.what());
      for (std::size_t i = 0; i < point_places.size(); ++i)
        if (error.part() == Part::point ? index == points + i : carrier_[i] == error.index())
          point_places[i].complain(error.what());
      throw;
    }
  }

 private:
  void for_each(const std::vector<JsonValue>& entries, const char* key,
                const std::function<void(const JsonValue&)>& define) {
    for (const JsonValue& entry : entries) {
      const auto given = entry.find(key);
      if (!given || !given->is_object()) continue;
      if (given->members().empty())
        given->complain("defines nothing; define something or leave it out");
      for (const JsonValue& value : given->members()) {
        require_closed_units(value);
        if (!taken_.insert(std::string(value.key())).second)
          value.complain("the name " + in_quotes(value.key()) +
                         " is taken by another point, vector or coordinate; choose another, or "
                         "list the names of what exists: \"" +
                         key + "\": [\"" + printable(value.key()) + "\"]");
        define(value);
      }
    }
  }

  void require_closed_units(const JsonValue& value) const {
    if (units_.length_is_open || units_.angle_is_open)
      value.complain(
          "the scene does not say in what unit this is; give \"version\": 2, in which the "
          "mechanism's units hold, or \"units\"");
  }

  void add_point(const JsonValue& value) {
    Mechanism::Point point{checked_name(value, value.key()), {}};
    value.allow({"body", "at"});
    const int carrier = names_.bodies.find(value["body"]);
    set_position(point, read_components(value["at"], mechanism_.dimension), units_.length);
    if (auto& own = mechanism_.bodies[carrier].own) {
      own->points.push_back(point.exact());
      point = {point.name, drawn_position(*own, point.position)};
    }
    mechanism_.bodies[carrier].points.push_back(static_cast<int>(mechanism_.points.size()));
    carrier_.push_back(carrier);
    mechanism_.points.push_back(std::move(point));
  }

  Mechanism::Coordinate read(const JsonValue& value, std::string_view key) const {
    Mechanism::Coordinate c = read_coordinate(value, mechanism_.dimension, units_, names_);
    if (c.is_angle() != (key == "angles"))
      value.complain(c.is_angle() ? "is an angle; define it under \"angles\""
                                  : "is no angle; define it under \"distances\"");
    return c;
  }

  const FileUnits& units_;
  Mechanism& mechanism_;
  Names names_;
  std::set<std::string, std::less<>> taken_;
  std::vector<int> carrier_;  // by defined point: index of the body that carries it
};

}  // namespace

void add_definitions(const std::vector<JsonValue>& entries, const FileUnits& units,
                     Mechanism& mechanism) {
  Definitions(units, mechanism).add(entries);
}

}  // namespace desmo
