// What mechanism and scene files have in common.
#pragma once

#include <string>
#include <string_view>

#include "cases/files/json_document.h"

namespace desmo {

/// Complains unless `format` is this one and `version` is 1.
void check_format(const JsonValue& root, std::string_view format);

/// A name as cases/files.md defines it: the text given, which stands at `place`.
std::string checked_name(const JsonValue& place, std::string_view name);

/// What one unit of a file is in metres and in radians.
struct Units {
  double length = 1;
  double angle = 1;
  std::string length_unit = "m";  ///< "m", or "1": any one unit
};

/// `units` of a file, which may be absent or leave out one of them; then the default holds.
Units read_units(const JsonValue& root, Units units);

}  // namespace desmo
