#include "cases/io/files.h"
#include "cases/io/readers.h"
#include "cases/io/text_file.h"
#include "cases/mechanism/checks.h"

namespace desmo {
namespace {

/// Returns the value that first gives a point or vector: in the file's list, or in the frame of a
/// body. Returns the root where there is none. kind: "points" or "vectors".
JsonValue place_of(const JsonValue& root, std::string_view kind, const std::string& name) {
  std::vector<JsonValue> owners = root["bodies"].members();
  owners.insert(owners.begin(), root);
  for (const JsonValue& owner : owners)
    if (const auto list = owner.find(kind); list && list->is_object())
      if (const auto place = list->find(name)) return *place;
  return root;
}

// Returns the value of the file that describes the entry that validate() refuses.
JsonValue place_of(const JsonValue& root, const Mechanism& mechanism, const MechanismError& error) {
  using Part = MechanismError::Part;
  const int i = error.index();
  const Part part = error.part();
  if (part == Part::point) return place_of(root, "points", mechanism.points[i].name);
  if (part == Part::vector) return place_of(root, "vectors", mechanism.vectors[i].name);
  if (part == Part::body) return i == 0 ? root["ground"] : root["bodies"][mechanism.bodies[i].name];
  if (part == Part::joint) return root["joints"].elements()[i];
  if (part == Part::coordinate) return root["coordinates"][mechanism.coordinates[i].name];
  if (part == Part::coupling) return root["couplings"][mechanism.couplings[i].name];
  return root;
}

}  // namespace

Mechanism::Vec read_components(const JsonValue& value, int dimension) {
  const std::vector<JsonValue> components = value.elements();
  if (components.size() != static_cast<std::size_t>(dimension))
    value.complain("wrong dimension: has " + std::to_string(components.size()) +
                   " components in a mechanism of dimension " + std::to_string(dimension) +
                   "; give as many components");
  Mechanism::Vec x{};
  for (int i = 0; i < dimension; ++i) x[i] = components[i].number();
  return x;
}

Mechanism::Direction read_direction(const JsonValue& value, const Names& names) {
  Mechanism::Direction d;
  if (value.is_string()) {
    d.vector = names.vectors.find(value);
    return d;
  }
  if (!value.is_array()) value.complain("is no direction; give a vector's name or two points");
  const auto [from, to] = names.points.find_pair(value);
  d.from = from;
  d.to = to;
  return d;
}

ReadMechanism mechanism_from(const JsonValue& root, NamedFiles& files) {
  check_format(root, "desmo-mechanism", 1);
  root.allow({"$schema", "format", "version", "name", "title", "dimension", "units", "points",
              "vectors", "ground", "bodies", "joints", "coordinates", "couplings", "drivers"});
  Mechanism mechanism;
  mechanism.name = checked_name(root["name"], root["name"].text());
  if (const auto title = root.find("title")) mechanism.title = title->line();
  mechanism.dimension = root["dimension"].whole_number(2, 3);
  DisplayUnits units = read_units(root, {});
  mechanism.length_unit = units.base_length();
  Names names;
  mechanism.points = read_points(root["points"], mechanism.dimension, units, names);
  mechanism.vectors = read_vectors(root, mechanism.dimension, mechanism.points, names);
  read_bodies(root, mechanism, units, names);
  mechanism.joints = read_joints(root, mechanism.dimension, units, names);
  name_joints(mechanism);
  mechanism.coordinates = read_coordinates(root, mechanism.dimension, units, names);
  mechanism.couplings = read_couplings(root, mechanism, units, names, files);
  try {
    validate(mechanism);
  } catch (const MechanismError& error) {
    place_of(root, mechanism, error).complain(error.what());
  }
  return {std::move(mechanism), std::move(units)};
}

Mechanism parse_mechanism(std::string_view text, const std::string& file_name) {
  const JsonDocument document(text, file_name);
  NamedFiles files{std::filesystem::path(file_name).parent_path()};
  return mechanism_from(document.root(), files).mechanism;
}

Mechanism read_mechanism(const std::filesystem::path& file) {
  return parse_mechanism(read_input(file), file.string());
}

}  // namespace desmo
