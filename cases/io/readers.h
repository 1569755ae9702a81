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

/// Return the units of lengths and angles that files may name.
std::span<const DisplayUnit> known_length_units();
std::span<const DisplayUnit> known_angle_units();

/// Returns the size of a unit in SI units. Lengths count as the doubles nearest to them.
Derived exact_size(const DisplayUnit& unit);

/// Reads `units` of a file; defaults hold for units that it leaves out.
FileUnits read_units(const JsonValue& root, FileUnits units);

/// Reads a unit of velocity, such as "deg/s" or "rpm", which is of angles. base_length: "m" or "1".
DisplayUnit read_rate_unit(const JsonValue& value, bool is_of_angle, std::string_view base_length);

/// Files that a file names, relative to its folder.
struct NamedFiles {
  std::filesystem::path folder;
  std::vector<std::filesystem::path> read{};  ///< those that were read

  /// Path and text of a file that has been read.
  struct Text {
    std::string name, text;
  };
  /// Reads the file that a value names. kind: "mechanism", for messages.
  Text read_named(const JsonValue& value, const std::string& kind);
};

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
/// files: where tables are.
ReadMechanism mechanism_from(const JsonValue& root, NamedFiles& files);

/// Reads as many components as the mechanism has dimensions; in the plane the third becomes 0.
Mechanism::Vec read_components(const JsonValue& value, int dimension);

/// Reads a vector's name, or a list of two points.
Mechanism::Direction read_direction(const JsonValue& value, const Names& names);

/// Places a point by numbers of the file in a unit of length.
void set_position(Mechanism::Point& point, const Mechanism::Vec& numbers, const DisplayUnit& unit);

std::vector<Mechanism::Point> read_points(const JsonValue& list, int dimension,
                                          const DisplayUnits& units, Names& names);

/// Reads `vectors` of the file, or of a body's frame.
std::vector<Mechanism::Vector> read_vectors(const JsonValue& root, int dimension,
                                            const std::vector<Mechanism::Point>& points,
                                            Names& names);

/// Reads the ground and the bodies. Adds points and vectors that only frames give, as the first of
/// these frames places them, moved by the mean offset of its points that are drawn.
void read_bodies(const JsonValue& root, Mechanism& mechanism, const DisplayUnits& units,
                 Names& names);

/// Returns the nominal position of a point of a body's frame.
Mechanism::Vec drawn_position(const Mechanism::Frame& frame, const Mechanism::Vec& local);

/// Reads joints; names of those without one are empty.
std::vector<Mechanism::Joint> read_joints(const JsonValue& root, int dimension,
                                          const DisplayUnits& units, const Names& names);

/// Reads relative coordinates and which of them are driven.
std::vector<Mechanism::Coordinate> read_coordinates(const JsonValue& root, int dimension,
                                                    const DisplayUnits& units, Names& names);

/// Reads one of them.
Mechanism::Coordinate read_coordinate(const JsonValue& value, int dimension,
                                      const DisplayUnits& units, const Names& names);

/// Reads couplings. Factors are those of lengths in metres (or the free unit) and angles in
/// radians; tables are in the units of the file. mechanism: its coordinates are read.
std::vector<Mechanism::Coupling> read_couplings(const JsonValue& root, const Mechanism& mechanism,
                                                const DisplayUnits& units, const Names& names,
                                                NamedFiles& files);

/// A scene, and what else its file tells.
struct ReadScene {
  Scene scene;
  DisplayUnits units;  ///< of motions: its own, or those of the mechanism where it names none
  std::vector<std::filesystem::path> files{};  ///< others that were read: mechanism, tables
};
/// folder: a mechanism file and tables are read relative to it.
ReadScene scene_from(const JsonValue& root, const std::filesystem::path& folder);

// Sections of a scene file:

/// Reads `motion`. Returns one motion for each driven coordinate, in the mechanism's order, in
/// metres (or the mechanism's free unit) or radians.
/// - files: where tables are
/// - known: the motions of coordinates that `motion` leaves out, one for each driven coordinate;
///   empty: it may leave out none
/// Throws InputError, also for a length whose unit the file leaves open.
std::vector<Motion> read_motions(const JsonValue& root, const Mechanism& mechanism,
                                 const FileUnits& units, NamedFiles& files,
                                 std::vector<Motion> known);

/// Reads one motion, of this coordinate.
Motion read_motion(const JsonValue& value, const Mechanism& mechanism,
                   const Mechanism::Coordinate& coordinate, const FileUnits& units,
                   NamedFiles& files);

/// Reads `from`, what a motion or a table starts from. Returns nothing for the drawing.
std::optional<Derived> read_from(const JsonValue& from, const DisplayUnit& unit);

/// A column of a table: arguments, which ascend, or values.
struct TableColumn {
  std::string_view key;                ///< of its list
  std::string_view name;               ///< in the heading of a file
  DisplayUnit unit;                    ///< of its numbers
  std::span<const DisplayUnit> units;  ///< those that a heading may name
  std::vector<double> numbers{};
};

/// Returns the column of a coordinate, empty. units: of the file that has the table.
TableColumn column_of(std::string_view key, const Mechanism::Coordinate& coordinate,
                      const DisplayUnits& units);

/// Reads a table from its lists, or from the CSV file that its `file` names; without a heading that
/// has two columns. Numbers are those of the file, and units those of its heading. coordinates:
/// those of the mechanism, of which a heading must name no other.
void read_table(const JsonValue& value, NamedFiles& files,
                const std::vector<Mechanism::Coordinate>& coordinates, TableColumn& arguments,
                TableColumn& values);

/// Names of ends in a file, in the order of SplineEnds.
inline constexpr std::array<std::string_view, 4> ends_names{"natural", "clamped", "periodic",
                                                            "indexing"};

/// Reads the ends of a table; natural where there are none. may_index: others than of a motion.
SplineEnds read_ends(const JsonValue& table, bool may_index);

/// Throws InputError when a table does not cover the grid's instants. motions: from read_motions().
void check_tables(const JsonValue& root, const Mechanism& mechanism,
                  const std::vector<Motion>& motions, const TimeGrid& grid);

/// Adds the points and coordinates that entries of a request define in place to the mechanism.
void add_definitions(const std::vector<JsonValue>& entries, const FileUnits& units,
                     Mechanism& mechanism);

/// Reads `request` into a scene that has its mechanism, in the order of first mention. What is
/// requested at several levels is listed once, at the highest. What is defined there is added to
/// the mechanism. units: those of the scene
void read_request(const JsonValue& root, const FileUnits& units, Scene& scene);

}  // namespace desmo
