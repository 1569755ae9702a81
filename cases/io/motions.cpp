#include "cases/io/readers.h"
#include "cases/mechanism/formatted.h"
#include "cases/mechanism/names.h"

namespace desmo {
namespace {

std::vector<int> driven_coordinates(const Mechanism& mechanism) {
  std::vector<int> driven;
  for (int i = 0; i < static_cast<int>(mechanism.coordinates.size()); ++i)
    if (mechanism.coordinates[i].driven) driven.push_back(i);
  return driven;
}

[[noreturn]] void complain_not_driven(const JsonValue& value, const Mechanism& mechanism,
                                      const NameTable& drivers) {
  for (const Mechanism::Coordinate& c : mechanism.coordinates)
    if (c.name == value.key())
      value.complain("the coordinate " + in_quotes(c.name) +
                     " is not driven; name it in the mechanism's drivers or leave its motion out");
  value.complain(unknown_name("driven coordinate", value.key(), drivers.names()));
}

}  // namespace

std::vector<Motion> read_motions(const JsonValue& root, const Mechanism& mechanism,
                                 const FileUnits& units, NamedFiles& files,
                                 std::vector<Motion> known) {
  const std::vector<int> driven = driven_coordinates(mechanism);
  std::vector<bool> has_motion(driven.size(), known.size() == driven.size());
  known.resize(driven.size());
  const auto given = root.find("motion");
  if (given) {
    NameTable drivers("driven coordinate");
    for (const int c : driven) drivers.add(mechanism.coordinates[c].name);
    for (const JsonValue& value : given->members()) {
      const auto i = drivers.position(value.key());
      if (!i) complain_not_driven(value, mechanism, drivers);
      known[*i] = read_motion(value, mechanism, mechanism.coordinates[driven[*i]], units, files);
      has_motion[*i] = true;
    }
  }
  for (std::size_t i = 0; i < driven.size(); ++i)
    if (!has_motion[i])
      given.value_or(root).complain("the driven coordinate " +
                                    in_quotes(mechanism.coordinates[driven[i]].name) +
                                    " has no motion; give one in \"motion\"");
  return known;
}

void check_tables(const JsonValue& root, const Mechanism& mechanism,
                  const std::vector<Motion>& motions, const TimeGrid& grid) {
  const std::vector<int> driven = driven_coordinates(mechanism);
  const double rounding = 1e-6 * grid.step;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const auto* const spline = std::get_if<Spline>(&motions[i]);
    if (!spline || (grid.time(0) >= spline->first_time() - rounding &&
                    grid.time(grid.instants - 1) <= spline->last_time() + rounding))
      continue;
    const std::string& name = mechanism.coordinates[driven[i]].name;
    root.find("time").value_or(root).complain(
        "the table of " + in_quotes(name) +
        formatted(" reaches only from %g s to %g s; analyse no other times or extend it",
                  spline->first_time(), spline->last_time()));
  }
}

}  // namespace desmo
