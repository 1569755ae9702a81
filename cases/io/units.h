// Units in which people write and read numbers. Everything inside is in SI units.
#pragma once

#include <string>
#include <string_view>

namespace desmo {

/// A unit of a quantity: {"mm", 1e-3}, {"deg/s", π/180}.
struct DisplayUnit {
  std::string name;
  double in_si = 1;  ///< size in m, rad and s; 1 for a free unit

  /// Return a value in this unit from one in SI units, and back. Each rounds once, and not at all
  /// where the unit is SI's.
  double from_si(double si) const { return si / in_si; }
  double to_si(double value) const { return value * in_si; }
};

/// Units of lengths and angles, in which a mechanism or a scene was written.
struct DisplayUnits {
  DisplayUnit length{"m", 1};  ///< {"1", 1}: a free unit
  DisplayUnit angle{"rad", 1};

  /// Returns the unit of lengths inside: "m", or "1" for an unspecified one.
  std::string_view base_length() const { return length.name == "1" ? "1" : "m"; }
  /// Returns the units in which lengths and angles are computed.
  DisplayUnits base() const { return {{std::string(base_length()), 1}, {"rad", 1}}; }
};

}  // namespace desmo
