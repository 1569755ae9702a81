// Ranges of a scene's drivers, collected once for all output formats.
#pragma once

#include <string>
#include <vector>

#include "bench/cli/units.h"
#include "formulations/verification/range/driver_range.h"

namespace desmo::cli {

/// An end of a driver's range (RangeEnd), with names for people.
struct NamedEnd {
  RangeEnd end;
  std::string direction;            ///< "down" or "up", seen from the start
  std::vector<std::string> joints;  ///< joints with a point that can still move at a dead point
  std::vector<std::string> bodies;  ///< bodies of the loop that holds the driver at a dead point
};

/// The range of a driver (DriverRange), with names for people.
struct NamedRange {
  std::string driver;
  bool is_angle;
  DisplayUnit unit;
  DriverRange range;
  std::vector<NamedEnd> ends;  ///< down, up; if the start is a dead point, that on the other branch
};

/// The ranges of all drivers of a scene.
struct Ranges {
  const Model& model;
  double time;  ///< time of the scene's start [s]
  std::vector<NamedRange> drivers;
};

/// Returns the ranges as text for people.
std::string to_text(const Ranges& ranges);
/// Returns the ranges as JSON, with all digits, and constraints by name.
std::string to_json(const Ranges& ranges);

}  // namespace desmo::cli
