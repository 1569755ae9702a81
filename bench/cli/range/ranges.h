// Ranges of a scene's drivers, collected once for all output formats.
#pragma once

#include <string>
#include <vector>

#include "bench/cli/units.h"
#include "formulations/verification/range/driver_range.h"

namespace desmo::cli {

/// End of a driver's way, with names.
struct NamedEnd {
  RangeEnd end;
  std::string direction;            ///< "down", "up"
  std::vector<std::string> joints;  ///< joints at points that can still move
  std::vector<std::string> bodies;  ///< bodies through which the driver is held: the loop
};

struct NamedRange {
  std::string driver;
  bool is_angle;
  DisplayUnit unit;
  DriverRange range;
  std::vector<NamedEnd> ends;  ///< down, up, then perhaps that on the other branch
};

struct Ranges {
  const Model& model;
  double time;  ///< of the start [s]
  std::vector<NamedRange> drivers;
};

std::string to_text(const Ranges& ranges);
std::string to_json(const Ranges& ranges);

}  // namespace desmo::cli
