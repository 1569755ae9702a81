// What mechanism and scene files have in common.
#pragma once

#include <string>
#include <string_view>

#include "cases/io/json_document.h"

namespace desmo {

/// Returns `version`, from 1 to `latest`. Complains unless `format` is this one, the version is
/// known and `$schema`, which is for editors and may be absent, is a text.
int check_format(const JsonValue& root, std::string_view format, int latest);

/// A name as cases/files.md defines it: the text given, which stands at `place`.
std::string checked_name(const JsonValue& place, std::string_view name);

/// The units of a file, in metres and in radians.
struct Units {
  double length = 1;
  double angle = 1;
  std::string length_unit = "m";                           ///< "m", or "1": any one unit
  std::string_view length_name = "m", angle_name = "rad";  ///< as in files
  /// Version 1 of a scene took metres and radians where it says no unit and the mechanism has
  /// another: nobody knows which is meant.
  bool length_is_open = false, angle_is_open = false;
};

/// Reads `units` of a file, which may be absent or leave out one of them; then the default holds.
Units read_units(const JsonValue& root, Units units);

}  // namespace desmo
