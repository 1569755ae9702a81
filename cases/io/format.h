// Elements common to mechanism and scene files.
#pragma once

#include <string>
#include <string_view>

#include "cases/io/json_document.h"

namespace desmo {

/// Returns the file's version, from 1 to `latest`. Throws InputError unless `format` is the file's,
/// the version is known, and the optional `$schema` (for editors) is a text.
int check_format(const JsonValue& root, std::string_view format, int latest);

/// Returns `name` if it is a name as cases/files.md defines it. place: its position, for errors.
std::string checked_name(const JsonValue& place, std::string_view name);

/// Units of a file, in metres and in radians.
struct Units {
  double length = 1;
  double angle = 1;
  std::string length_unit = "m";                           ///< "m", or "1": an unspecified unit
  std::string_view length_name = "m", angle_name = "rad";  ///< names in files
  /// Ambiguity of the units. Version 1 of a scene assumed metres and radians where it named no
  /// unit, although the mechanism may have others.
  bool length_is_open = false, angle_is_open = false;
};

/// Reads `units` of a file; defaults hold for units that it leaves out.
Units read_units(const JsonValue& root, Units units);

}  // namespace desmo
