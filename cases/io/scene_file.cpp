#include <cmath>

#include "cases/generators/cases.h"
#include "cases/io/files.h"
#include "cases/io/readers.h"
#include "cases/io/text_file.h"
#include "cases/library/library.h"
#include "cases/mechanism/formatted.h"
#include "cases/mechanism/names.h"

namespace desmo {
namespace {

constexpr int max_units = 100'000;    // number of a generator's units that a file may ask for, ≤
constexpr double max_instants = 1e9;  // number of instants, ≤

constexpr int latest_version = 2;  // latest version of scene files

TimeGrid read_time(const JsonValue& value) {
  value.require_object(R"({"end": 1, "step": 0.01})");
  if (const auto at = value.find("at")) {
    value.allow({"at"});
    return {at->number(), 1, 1};
  }
  value.allow({"start", "end", "step"});
  const auto start_given = value.find("start");
  const double start = start_given ? start_given->number() : 0;
  const JsonValue end_given = value["end"], step_given = value["step"];
  const double end = end_given.number(), step = step_given.number();
  if (!(step > 0))
    step_given.complain("the step is not above 0; give seconds from instant to instant");
  if (!(end > start)) end_given.complain("the end is not after the start; give a later one");
  const double intervals = (end - start) / step;
  if (!(intervals <= max_instants - 1))
    step_given.complain("gives more than 1e9 instants; choose a longer step or an earlier end");
  constexpr double rounding = 1e-3;  // duration / step may differ by this from a whole number
  if (intervals < 1 - rounding || std::abs(intervals - std::round(intervals)) > rounding)
    step_given.complain(
        formatted("from start to end are %.12g steps, no whole number; choose another step or end",
                  intervals));
  if (!(start + step > start) || !(end - step < end))
    step_given.complain("the step vanishes beside such large times; choose a longer step");
  TimeGrid grid = time_grid(end - start, step);
  grid.start = start;
  return grid;
}

// The functions below read the mechanism of a scene, with its units. Mechanisms of the library and
// of generators come with motions, one for each driven coordinate, and with instants; others have
// neither.

ReadScene without_motion(ReadMechanism read) {
  Scene scene;
  scene.mechanism = std::move(read.mechanism);
  return {std::move(scene), std::move(read.units)};
}

ReadScene from_library(const JsonValue& value) {
  value.allow({"library"});
  const LibraryMechanism& found =
      library()[value["library"].choose("library mechanism", names_of(library()))];
  const std::string file_name = "library/" + std::string(found.name);
  const JsonDocument mechanism(found.mechanism, file_name + ".json"),
      scene(found.scene, file_name + ".scene.json");
  NamedFiles none;
  ReadScene start = without_motion(mechanism_from(mechanism.root(), none));
  start.scene.motions = read_motions(scene.root(), start.scene.mechanism,
                                     read_units(scene.root(), {start.units}), none, {});
  start.scene.grid = read_time(scene.root()["time"]);
  return start;
}

ReadScene from_generator(const JsonValue& value) {
  const Case& c = cases()[value["generator"].choose("generator", names_of(cases()))];
  value.allow({"generator", c.unit_name});
  const JsonValue count = value[c.unit_name];
  try {
    Scene scene = c.with_units(count.whole_number(1, max_units));
    DisplayUnits units{.length = {scene.mechanism.length_unit}};
    return {std::move(scene), std::move(units)};
  } catch (const std::invalid_argument& error) {
    count.complain(std::string(error.what()) + "; choose another number");
  }
}

ReadScene from_file(const JsonValue& value, NamedFiles& files) {
  const auto [name, text] = files.read_named(value, "mechanism");
  const JsonDocument document(text, name);
  NamedFiles own{std::filesystem::path(name).parent_path()};
  ReadScene start = without_motion(mechanism_from(document.root(), own));
  files.read.insert(files.read.end(), own.read.begin(), own.read.end());
  return start;
}

ReadScene read_start(const JsonValue& value, NamedFiles& files) {
  if (value.is_string()) return from_file(value, files);
  if (!value.is_object())
    value.complain(
        "is no mechanism; give a file name, a mechanism, {\"library\": name} or "
        "{\"generator\": name}");
  if (value.find("library")) return from_library(value);
  if (value.find("generator")) return from_generator(value);
  return without_motion(mechanism_from(value, files));
}

// Returns the units of a scene's motions. Refuses a length in metres where the mechanism has a free
// unit, and the reverse.
FileUnits units_of_motion(const JsonValue& root, int version, const DisplayUnits& mechanism) {
  FileUnits units = read_units(root, {mechanism});
  if (units.base_length() != mechanism.base_length())
    root["units"]["length"].complain(
        mechanism.base_length() == "1"
            ? "the mechanism's unit of length is '1', any one unit; give '1' here as well"
            : "the mechanism has lengths in metres; give 'm', 'mm', 'cm' or 'in'");
  if (version > 1) return units;
  const auto given = root.find("units");
  units.length_is_open = mechanism.length.in_si != 1 && !(given && given->find("length"));
  units.angle_is_open = mechanism.angle.in_si != 1 && !(given && given->find("angle"));
  return units;
}

std::string read_formulation(const JsonValue& value) {
  constexpr const char* allowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_/:.-";
  const std::string_view id = value.text();
  constexpr std::size_t max_id = 200;
  if (id.empty() || id.size() > max_id || id.find_first_not_of(allowed) != id.npos)
    value.complain(in_quotes(id) + " is no formulation; give an id that 'desmo list' shows");
  return std::string(id);
}

double read_tolerance(const JsonValue& value) {
  const double tolerance = value.number();
  if (!(tolerance > 0)) value.complain("the tolerance is not above 0; give one such as 1e-10");
  return tolerance;
}

}  // namespace

ReadScene scene_from(const JsonValue& root, const std::filesystem::path& folder) {
  const int version = check_format(root, "desmo-scene", latest_version);
  root.allow({"$schema", "format", "version", "name", "mechanism", "units", "motion", "time",
              "request", "formulation", "tolerance"});
  NamedFiles files{folder};
  auto [scene, units_of_mechanism, none] = read_start(root["mechanism"], files);
  const auto name = root.find("name");
  scene.name = name ? std::string(name->line()) : scene.mechanism.name;
  FileUnits units = units_of_motion(root, version, units_of_mechanism);
  scene.motions = read_motions(root, scene.mechanism, units, files, std::move(scene.motions));
  if (scene.grid.instants == 0 || root.find("time")) scene.grid = read_time(root["time"]);
  check_tables(root, scene.mechanism, scene.motions, scene.grid);
  read_request(root, units, scene);
  if (const auto id = root.find("formulation")) scene.formulation = read_formulation(*id);
  if (const auto given = root.find("tolerance")) scene.tolerance = read_tolerance(*given);
  return {std::move(scene), std::move(units), std::move(files.read)};
}

Scene parse_scene(std::string_view text, const std::string& file_name,
                  const std::filesystem::path& folder) {
  const JsonDocument document(text, file_name);
  return scene_from(document.root(), folder).scene;
}

Scene read_scene(const std::filesystem::path& file) {
  return parse_scene(read_input(file), file.string(), file.parent_path());
}

Scene library_scene(std::string_view name) {
  return parse_scene(entry_named(name, library(), "library mechanism").scene, std::string(name),
                     {});
}

}  // namespace desmo
