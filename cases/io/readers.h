// Readers of the sections of mechanism and scene files. All throw InputError.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "cases/io/json_document.h"
#include "cases/io/name_table.h"
#include "cases/io/units.h"
#include "cases/mechanism/mechanism.h"
#include "cases/mechanism/scene.h"

namespace desmo {

// What both kinds of file have:

/// Returns the file's version, from 1 to `latest`. Throws InputError unless `format` is the file's,
/// the version is known, and the optional `$schema` (for editors) is a text.
int check_format(const JsonValue& root, std::string_view format, int latest);

/// Returns `name` if it is a name as cases/files.md defines it. place: its position, for errors.
std::string checked_name(const JsonValue& place, std::string_view name);

/// Units of a file.
struct FileUnits : DisplayUnits {
  /// Ambiguity of the units. Version 1 of a scene assumed metres and radians where it named no
  /// unit, although the mechanism may have others.
  bool length_is_open = false, angle_is_open = false;
};

/// Reads `units` of a file; defaults hold for units that it leaves out.
FileUnits read_units(const JsonValue& root, FileUnits units);

// Sections of a mechanism file, in reading order:

/// Known names; references to texts of the document.
struct Names {
  NameTable points{"point"}, vectors{"vector"}, bodies{"body"}, coordinates{"coordinate"};
};

/// A validated mechanism and the units of its file.
struct ReadMechanism {
  Mechanism mechanism;
  DisplayUnits units;
};
ReadMechanism mechanism_from(const JsonValue& root);

/// Reads as many components as the mechanism has dimensions; in the plane the third becomes 0.
Mechanism::Vec read_components(const JsonValue& value, int dimension);

/// Reads a vector's name, or a list of two points.
Mechanism::Direction read_direction(const JsonValue& value, const Names& names);

std::vector<Mechanism::Vector> read_vectors(const JsonValue& root, int dimension,
                                            const std::vector<Mechanism::Point>& points,
                                            Names& names);

/// Reads joints; names of those without one are empty.
std::vector<Mechanism::Joint> read_joints(const JsonValue& root, const Names& names);

/// Reads relative coordinates and which of them are driven.
std::vector<Mechanism::Coordinate> read_coordinates(const JsonValue& root, int dimension,
                                                    const DisplayUnits& units, Names& names);

// Sections of a scene file:

/// Reads `motion`. Returns one motion for each driven coordinate, in the mechanism's order, in
/// metres (or the mechanism's free unit) or radians.
/// - known: the motions of coordinates that `motion` leaves out, one for each driven coordinate;
///   empty: it may leave out none
/// Throws InputError, also for a length whose unit the file leaves open.
std::vector<Motion> read_motions(const JsonValue& root, const Mechanism& mechanism,
                                 const FileUnits& units, std::vector<Motion> known);

/// Throws InputError when a table does not cover the grid's instants. motions: from read_motions().
void check_tables(const JsonValue& root, const Mechanism& mechanism,
                  const std::vector<Motion>& motions, const TimeGrid& grid);

/// Reads `request`, in the order of first mention. An entity requested at several levels is listed
/// once, at the highest. Returns an empty list when the file has no request.
std::vector<RequestedEntity> read_request(const JsonValue& root, const Mechanism& mechanism);

}  // namespace desmo
