// Units in which people write and read numbers. The program computes in SI units, or in the free
// unit of length.
#pragma once

#include <string>
#include <string_view>

namespace desmo {

/// A unit of a quantity: {"mm", 1e-3}, {"deg/s", π/180}.
struct DisplayUnit {
  std::string name;
  double in_si = 1;  ///< size in SI units; 1 for a free unit

  /// Convert a value from SI units to this unit, and back. Each rounds once, and not at all where
  /// in_si is 1.
  double from_si(double si) const { return si / in_si; }
  double to_si(double value) const { return value * in_si; }
};

/// Units of lengths and angles in which a mechanism or a scene was written.
struct DisplayUnits {
  DisplayUnit length{"m", 1};  ///< {"1", 1}: a free unit
  DisplayUnit angle{"rad", 1};

  const DisplayUnit& of(bool is_angle) const { return is_angle ? angle : length; }
  /// Returns the unit in which lengths are computed: "m", or "1" for the free unit.
  std::string_view base_length() const { return length.name == "1" ? "1" : "m"; }
  /// Returns the units in which lengths and angles are computed.
  DisplayUnits base() const { return {{std::string(base_length()), 1}, {"rad", 1}}; }
};

}  // namespace desmo
