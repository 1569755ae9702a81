#include <algorithm>
#include <array>
#include <numbers>
#include <span>

#include "cases/io/readers.h"
#include "cases/io/text_file.h"
#include "cases/mechanism/names.h"

namespace desmo {
namespace {

const std::array length_units{DisplayUnit{"m", 1}, DisplayUnit{"mm", 1e-3}, DisplayUnit{"cm", 1e-2},
                              DisplayUnit{"in", 0.0254}, DisplayUnit{"1", 1}};
const std::array angle_units{DisplayUnit{"rad", 1}, DisplayUnit{"deg", std::numbers::pi / 180}};

const DisplayUnit& read_unit(const JsonValue& value, std::span<const DisplayUnit> units) {
  const std::string_view name = value.text();
  const auto found = std::ranges::find(units, name, &DisplayUnit::name);
  if (found != units.end()) return *found;
  value.complain("unknown unit " + in_quotes(name) + "; " + enumeration(names_of(units)));
}

}  // namespace

std::span<const DisplayUnit> known_units(bool is_angle) {
  if (is_angle) return angle_units;
  return length_units;
}

Derived exact_size(const DisplayUnit& unit) {
  if (unit.name.starts_with("deg")) return Derived::pi() / 180;
  if (unit.name == "rpm") return Derived::pi() / 30;
  if (unit.name == "Hz") return Derived::pi() * 2;
  return unit.in_si;
}

int check_format(const JsonValue& root, std::string_view format, int latest) {
  const auto given = root.find("format");
  if (!given)
    root.complain("the key 'format' is missing; add it: \"format\": \"" + std::string(format) +
                  '"');
  if (given->text() != format) {
    const bool known = given->text() == "desmo-scene" || given->text() == "desmo-mechanism";
    given->complain("the format is " + in_quotes(given->text()) + ", not " + in_quotes(format) +
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
                   " letters, digits, blanks (within) and _ . / - (not first)");
  return std::string(name);
}

FileUnits read_units(const JsonValue& root, FileUnits units) {
  const auto given = root.find("units");
  if (!given) return units;
  given->require_object(R"({"length": "mm", "angle": "deg"})");
  given->allow({"length", "angle"});
  if (const auto value = given->find("length")) units.length = read_unit(*value, length_units);
  if (const auto value = given->find("angle")) units.angle = read_unit(*value, angle_units);
  return units;
}

DisplayUnit read_rate_unit(const JsonValue& value, bool is_of_angle, std::string_view base) {
  std::vector<DisplayUnit> rates;
  if (is_of_angle) rates.push_back({"rpm", std::numbers::pi / 30});
  for (const DisplayUnit& unit : known_units(is_of_angle))
    if (is_of_angle || (unit.name == "1") == (base == "1"))
      rates.push_back({unit.name + "/s", unit.in_si});
  return read_unit(value, rates);
}

NamedFiles::Text NamedFiles::read_named(const JsonValue& value, const std::string& kind) {
  const std::string_view name = value.text();
  if (name.empty() || name.find('\0') != name.npos)
    value.complain(in_quotes(name) + " is no file name; give that of a " + kind + " file");
  const std::filesystem::path file = (folder / name).lexically_normal();
  try {
    std::string text = read_text(file);
    read.push_back(file);
    return {file.string(), std::move(text)};
  } catch (const UnreadableFile& error) {
    value.complain("the " + kind + " file '" + printable(file.string(), 300) +
                   "': " + error.what());
  }
}

}  // namespace desmo
