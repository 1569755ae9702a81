#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "bench/cli/range/ranges.h"
#include "bench/cli/text.h"
#include "cases/mechanism/formatted.h"

namespace desmo::cli {
namespace {

using Json = nlohmann::ordered_json;

/// A way in which a range ends: its name in JSON, and what the text says of it.
struct StopText {
  const char *name, *text;
};

/// Names and texts in the order of RangeStop. sentence() replaces texts that depend on the end.
constexpr StopText stops[] = {
    {"dead_point", "locks, known within "},
    {"full_turn", "turns fully"},
    {"zero_length", "the length is zero"},
    {"other_branch", "beyond, equations left out as dependent do not hold"},
    {"start", "the start is a change point, where branches meet: start elsewhere"},
    {"not_reached", "no position was found any further"},
    {"none", "does not stop within ten times the mechanism's size"},
};
static_assert(std::size(stops) == static_cast<std::size_t>(RangeStop::none) + 1);

const StopText& stop_of(const RangeEnd& end) { return stops[static_cast<std::size_t>(end.stop)]; }

/// The value of a driver as text, and by how much it may be off.
struct KnownValue {
  std::string text;
  double uncertainty;  // in the unit of the text; includes the rounding of the text
};

/// Returns the value at a dead point with the digits that are known, 17 at most.
KnownValue dead_point_value(const RangeEnd& end, const DisplayUnit& unit) {
  const double value = unit.from_si(end.value);
  // Both conversions to the unit round.
  const double known = std::abs(unit.from_si(end.beyond) - value) +
                       std::numeric_limits<double>::epsilon() * std::abs(value);
  const auto exponent = [](double x) { return x > 0 ? std::floor(std::log10(x)) : 0; };
  const double digits = exponent(std::abs(value)) + 1 - exponent(known);
  const std::string number =
      formatted("%.*g", static_cast<int>(std::clamp(digits, 1., 17.)), value == 0 ? 0 : value);
  const double rounding = std::abs(std::strtod(number.c_str(), nullptr) - value);
  return {number + (unit.name == "1" ? "" : " " + unit.name), known + rounding};
}

/// Returns a text of two digits that is not below x.
std::string rounded_up(double x, const DisplayUnit& unit) {
  constexpr double up = 1.05;  // two digits are at most 5 % less than what they stand for
  return formatted("%.1e", up * x) + (unit.name == "1" ? "" : " " + unit.name);
}

std::string value_text(const NamedEnd& e, const DisplayUnit& unit) {
  return e.end.stop == RangeStop::dead_point ? dead_point_value(e.end, unit).text
                                             : quantity(e.end.value, unit);
}

std::string sentence(const NamedEnd& e, const NamedRange& r) {
  if (e.end.stop == RangeStop::full_turn && e.end.turns != 1)
    return "comes back after two turns, on another branch after one";
  if (e.end.stop == RangeStop::none && r.is_angle)
    return "does not stop, nor come back to the start in two turns";
  const std::string text = stop_of(e.end).text;
  if (e.end.stop != RangeStop::dead_point) return text;
  return text + rounded_up(dead_point_value(e.end, r.unit).uncertainty, r.unit);
}

std::string detail(const std::string& label, const std::string& text) {
  constexpr std::size_t indent = 16;
  return "        " + label + std::string(indent - 8 - label.size(), ' ') + wrap(text, indent) +
         "\n";
}

std::string group_and_bodies(GroupId g, const Model& m) {
  return m.groups[g].name + " (" + enumerate(m.groups[g].bodies, 8) + ")";
}

std::string end_text(const NamedEnd& e, const NamedRange& r, const Model& m) {
  std::string text = "  " + e.direction + std::string(6 - e.direction.size(), ' ') +
                     value_text(e, r.unit) + ": " + sentence(e, r) + "\n";
  if (e.end.stop != RangeStop::dead_point) return text;
  for (const GroupId g : e.end.groups) text += detail("group", group_and_bodies(g, m));
  text += detail("moves",
                 enumerate(names_at(m.entities, e.end.moving), 8) + ", while all drivers rest");
  if (!e.joints.empty()) text += detail("joints", enumerate(e.joints, 8));
  return text + detail("loop", enumerate(e.bodies, 12));
}

Json end_json(const NamedEnd& e, const DisplayUnit& unit, const Model& m) {
  Json j = {{"direction", e.direction},
            {"stop", stop_of(e.end).name},
            {"value", unit.from_si(e.end.value)},
            {"beyond", unit.from_si(e.end.beyond)}};
  if (e.end.stop == RangeStop::full_turn) j["turns"] = e.end.turns;
  if (e.end.stop != RangeStop::dead_point) return j;
  j.update({{"groups", names_at(m.groups, e.end.groups)},
            {"moving", names_at(m.entities, e.end.moving)},
            {"joints", e.joints},
            {"loop", e.bodies},
            {"constraints", names_at(m.constraints, e.end.constraints)}});
  return j;
}

}  // namespace

std::string to_text(const Ranges& ranges) {
  const Model& m = ranges.model;
  std::string text = m.name + ", from t = " + formatted("%.12g s", ranges.time) +
                     ": how far each driver goes while the others rest\n";
  for (const NamedRange& r : ranges.drivers) {
    text += "\n" + r.driver + ", from " + quantity(r.range.start, r.unit) +
            (r.range.is_idle ? ": moves nothing else\n" : "\n");
    if (r.range.is_idle) continue;
    for (std::size_t i = 0; i < r.ends.size(); ++i) {
      if (i == 2) text += "  the start is a dead point; on the other branch from it\n";
      text += end_text(r.ends[i], r, m);
    }
    for (const ChangePoint& c : r.range.change_points)
      text += "  " +
              wrap("passes the singular position " + quantity(c.value, r.unit) +
                       (c.is_double ? ", where no determinant changes its sign"
                                    : ", where branches meet") +
                       (c.group < 0 ? "" : ": " + group_and_bodies(c.group, m)),
                   4) +
              "\n";
  }
  return text;
}

std::string to_json(const Ranges& ranges) {
  const Model& m = ranges.model;
  Json drivers = Json::array();
  for (const NamedRange& r : ranges.drivers) {
    Json ends = Json::array(), changes = Json::array();
    if (!r.range.is_idle)
      for (const NamedEnd& e : r.ends) ends.push_back(end_json(e, r.unit, m));
    for (const ChangePoint& c : r.range.change_points)
      changes.push_back({{"value", r.unit.from_si(c.value)},
                         {"double", c.is_double},
                         {"group", c.group < 0 ? Json() : Json(m.groups[c.group].name)}});
    drivers.push_back({{"name", r.driver},
                       {"unit", r.unit.name},
                       {"start", r.unit.from_si(r.range.start)},
                       {"idle", r.range.is_idle},
                       {"ends", ends},
                       {"change_points", changes}});
  }
  const Json all = {{"name", m.name}, {"time", ranges.time}, {"drivers", drivers}};
  return all.dump(1) + "\n";
}

}  // namespace desmo::cli
