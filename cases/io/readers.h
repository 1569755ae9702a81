// Readers of the sections of mechanism and scene files. All throw InputError.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cases/io/json_document.h"
#include "cases/io/name_table.h"
#include "cases/io/units.h"
#include "cases/mechanism/mechanism.h"
#include "cases/mechanism/scene.h"

namespace desmo {

// Readers of parts that both kinds of file have:

/// Returns the file's version, 1 or `latest`. Throws InputError unless the file has this format and
/// one of these versions, and its optional `$schema` (for editors) is a text.
int check_format(const JsonValue& root, std::string_view format, int latest);

/// Returns `name` if it is a name (is_name()). Throws InputError otherwise. place: value that the
/// message refers to.
std::string checked_name(const JsonValue& place, std::string_view name);

/// Units of a file.
struct FileUnits : DisplayUnits {
  /// True: the file leaves the unit open, and a number that needs it is refused. In a scene of
  /// version 1 it is open where the scene names no unit, and the mechanism has another than m or
  /// rad.
  bool length_is_open = false, angle_is_open = false;
};

/// Returns the units of angles, or of lengths, that files may name.
std::span<const DisplayUnit> known_units(bool is_angle);

/// Returns the size of a unit in SI units: with its remainder where π is in it; for others the
/// double DisplayUnit::in_si counts as exact.
Derived exact_size(const DisplayUnit& unit);

/// Reads `units` of a file. units: those that hold where the file names none.
FileUnits read_units(const JsonValue& root, FileUnits units);

/// Reads a unit of velocity, such as "mm/s", or, of an angle, "deg/s" or "rpm".
/// - base_length: DisplayUnits::base_length() of the mechanism, "m" or "1"
DisplayUnit read_rate_unit(const JsonValue& value, bool is_of_angle, std::string_view base_length);

/// Files that a file names.
struct NamedFiles {
  std::filesystem::path folder;               ///< folder to which their names are relative
  std::vector<std::filesystem::path> read{};  ///< paths of the files that were read

  /// Path and text of a file that has been read.
  struct Text {
    std::string name, text;
  };
  /// Reads the file that a value names. kind: word for messages, such as "mechanism".
  Text read_named(const JsonValue& value, const std::string& kind);
};

// Sections of a mechanism file, in reading order:

/// Names that were read so far. They refer to texts of the document, which must outlive them.
struct Names {
  NameTable points{"point"}, vectors{"vector"}, bodies{"body"}, coordinates{"coordinate"};
};

/// A validated mechanism and the units of its file.
struct ReadMechanism {
  Mechanism mechanism;
  DisplayUnits units;
};
/// Reads and validates a mechanism. files: reader of its table files.
ReadMechanism mechanism_from(const JsonValue& root, NamedFiles& files);

/// Reads as many components as the mechanism has dimensions; in the plane the third becomes 0.
Mechanism::Vec read_components(const JsonValue& value, int dimension);

/// Reads a vector's name, or a list of two names of points.
Mechanism::Direction read_direction(const JsonValue& value, const Names& names);

/// Sets the position of a point, with its remainder, from numbers in a unit of length.
void set_position(Mechanism::Point& point, const Mechanism::Vec& numbers, const DisplayUnit& unit);

/// Reads `points` of the file, or of a body's frame. Adds their names to `names`.
std::vector<Mechanism::Point> read_points(const JsonValue& list, int dimension,
                                          const DisplayUnits& units, Names& names);

/// Reads `vectors` of the file, or of a body's frame. Adds their names to `names`.
/// - root: the file or the body; points: those to which `along` and `normal` may refer
std::vector<Mechanism::Vector> read_vectors(const JsonValue& root, int dimension,
                                            const std::vector<Mechanism::Point>& points,
                                            Names& names);

/// Reads the ground and the bodies. A point or vector that only frames of bodies give is added to
/// the mechanism; the first such frame places it. A frame may have some points that were placed
/// before, and some that were not. It is then first moved, so that those placed before are, on
/// average, where they were placed.
void read_bodies(const JsonValue& root, Mechanism& mechanism, const DisplayUnits& units,
                 Names& names);

/// Returns the nominal position of a point. local: its position in a body's frame.
Mechanism::Vec drawn_position(const Mechanism::Frame& frame, const Mechanism::Vec& local);

/// Reads joints. Joints without a name get an empty one.
std::vector<Mechanism::Joint> read_joints(const JsonValue& root, int dimension,
                                          const DisplayUnits& units, const Names& names);

/// Reads relative coordinates and which of them are driven.
std::vector<Mechanism::Coordinate> read_coordinates(const JsonValue& root, int dimension,
                                                    const DisplayUnits& units, Names& names);

/// Reads one relative coordinate, not driven.
Mechanism::Coordinate read_coordinate(const JsonValue& value, int dimension,
                                      const DisplayUnits& units, const Names& names);

/// Reads couplings. Factors of sums are converted to those of lengths in metres (or the free unit)
/// and angles in radians, up to a common factor. Numbers of a table keep its units, to which
/// the factors in Mechanism::Coupling::terms convert the coordinates.
/// - mechanism: its coordinates have been read
std::vector<Mechanism::Coupling> read_couplings(const JsonValue& root, const Mechanism& mechanism,
                                                const DisplayUnits& units, const Names& names,
                                                NamedFiles& files);

/// A scene, its units, and the files that were read for it.
struct ReadScene {
  Scene scene;
  DisplayUnits units;  ///< units of motions: the scene's, or the mechanism's where it names none
  std::vector<std::filesystem::path> files{};  ///< other files that were read: mechanism, tables
};
/// Reads a scene. folder: folder to which its mechanism file and table files are relative.
ReadScene scene_from(const JsonValue& root, const std::filesystem::path& folder);

// Sections of a scene file:

/// Reads `motion`. Returns one motion for each driven coordinate, in the mechanism's order, in
/// metres (or the mechanism's free unit) or radians.
/// - files: reader of table files
/// - known: one motion for each driven coordinate, which holds where `motion` leaves it out; empty:
///   `motion` must leave out none
/// Throws InputError, also for a number whose unit the file leaves open.
std::vector<Motion> read_motions(const JsonValue& root, const Mechanism& mechanism,
                                 const FileUnits& units, NamedFiles& files,
                                 std::vector<Motion> known);

/// Reads the motion of a coordinate.
Motion read_motion(const JsonValue& value, const Mechanism& mechanism,
                   const Mechanism::Coordinate& coordinate, const FileUnits& units,
                   NamedFiles& files);

/// Reads `from`, the constant that is added to a motion or a table, into SI units. Returns nothing
/// for "drawing".
std::optional<Derived> read_from(const JsonValue& from, const DisplayUnit& unit);

/// A column of a table: arguments, which ascend, or values.
struct TableColumn {
  std::string_view key;                ///< key of its list in a scene or mechanism file
  std::string_view name;               ///< its name in the heading of a CSV file
  DisplayUnit unit;                    ///< unit of its numbers
  std::span<const DisplayUnit> units;  ///< units that a heading may name
  std::vector<double> numbers{};
};

/// Returns a column for the values of a coordinate, without numbers.
/// - key: TableColumn::key; units: those of the file that has or names the table
TableColumn column_of(std::string_view key, const Mechanism::Coordinate& coordinate,
                      const DisplayUnits& units);

/// Reads a table from its lists, or from the CSV file that its `file` names. Numbers are not
/// converted; units of a CSV file's heading become those of the columns.
/// - coordinates: those of the mechanism. A heading of two columns may give a column any name but
///   that of the other column or of another coordinate
void read_table(const JsonValue& value, NamedFiles& files,
                const std::vector<Mechanism::Coordinate>& coordinates, TableColumn& arguments,
                TableColumn& values);

/// Names of ends in a file, in the order of SplineEnds.
inline constexpr std::array<std::string_view, 4> ends_names{"natural", "clamped", "periodic",
                                                            "indexing"};

/// Reads the ends of a table; natural where none are given. may_index: "indexing" is allowed, as in
/// couplings.
SplineEnds read_ends(const JsonValue& table, bool may_index);

/// Throws InputError when the table of a motion does not cover the grid's instants, up to 1e-6 of a
/// step. motions: one for each driven coordinate, in the mechanism's order.
void check_tables(const JsonValue& root, const Mechanism& mechanism,
                  const std::vector<Motion>& motions, const TimeGrid& grid);

/// Adds the points and coordinates to the mechanism that entries of a request define.
void add_definitions(const std::vector<JsonValue>& entries, const FileUnits& units,
                     Mechanism& mechanism);

/// Reads `request` into a scene that has its mechanism. Entities and measures are listed once, in
/// the order of first mention, at the highest level requested. What the request defines is added to
/// the mechanism.
/// - units: those of the scene
void read_request(const JsonValue& root, const FileUnits& units, Scene& scene);

}  // namespace desmo
