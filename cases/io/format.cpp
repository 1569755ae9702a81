#include <algorithm>
#include <array>
#include <numbers>
#include <span>

#include "cases/io/readers.h"
#include "cases/mechanism/names.h"

namespace desmo {
namespace {

struct Unit {
  std::string_view name;
  double in_si;
};

constexpr std::array length_units{Unit{"m", 1}, Unit{"mm", 1e-3}, Unit{"cm", 1e-2},
                                  Unit{"in", 0.0254}, Unit{"1", 1}};
constexpr std::array angle_units{Unit{"rad", 1}, Unit{"deg", std::numbers::pi / 180}};

const Unit& read_unit(const JsonValue& value, std::span<const Unit> units) {
  const std::string_view name = value.text();
  const auto found = std::ranges::find(units, name, &Unit::name);
  if (found != units.end()) return *found;
  std::vector<std::string_view> names;
  for (const Unit& unit : units) names.push_back(unit.name);
  value.complain("unknown unit " + in_quotes(name) + "; " + enumeration(names));
}

}  // namespace

int check_format(const JsonValue& root, std::string_view format, int latest) {
  const JsonValue given = root["format"];
  if (given.text() != format) {
    const bool known = given.text() == "desmo-scene" || given.text() == "desmo-mechanism";
    given.complain("the format is " + in_quotes(given.text()) + ", not " + in_quotes(format) +
                   "; " + (known ? "give the other kind of file here" : "correct it"));
  }
  const JsonValue version = root["version"];
  if (version.number() != 1 && version.number() != latest)
    version.complain("this version of the format is not known; " +
                     std::string(latest == 1
                                     ? "version 1 is"
                                     : "versions 1 and " + std::to_string(latest) + " are"));
  if (const auto schema = root.find("$schema")) schema->text();
  return static_cast<int>(version.number());
}

std::string checked_name(const JsonValue& place, std::string_view name) {
  if (!is_name(name))
    place.complain(in_quotes(name) + " is not a name; use 1 to " + std::to_string(max_name) +
                   " letters, digits and _ . / - (not first)");
  return std::string(name);
}

Units read_units(const JsonValue& root, Units units) {
  const auto given = root.find("units");
  if (!given) return units;
  given->allow({"length", "angle"});
  if (const auto value = given->find("length")) {
    const Unit& unit = read_unit(*value, length_units);
    units.length = unit.in_si;
    units.length_unit = unit.name == "1" ? "1" : "m";
    units.length_name = unit.name;
  }
  if (const auto value = given->find("angle")) {
    const Unit& unit = read_unit(*value, angle_units);
    units.angle = unit.in_si;
    units.angle_name = unit.name;
  }
  return units;
}

}  // namespace desmo
