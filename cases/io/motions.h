#pragma once

#include "cases/io/format.h"
#include "cases/mechanism/mechanism.h"
#include "cases/mechanism/motion.h"

namespace desmo {

/// Reads the motion of one coordinate, in metres (or the mechanism's free unit) or radians. Throws
/// InputError where it needs an ambiguous unit.
Motion read_motion(const JsonValue& value, Mechanism::CoordinateType coordinate,
                   const Units& units);

/// Reads `motion` of a scene: one for each driven coordinate, in the mechanism's order. known:
/// motions, for all driven coordinates or none, that the scene may leave out.
std::vector<Motion> read_motions(const JsonValue& root, const Mechanism& mechanism,
                                 const Units& units, std::vector<Motion> known);

/// Throws InputError when a table does not cover the grid's instants. motions: from read_motions().
void check_tables(const JsonValue& root, const Mechanism& mechanism,
                  const std::vector<Motion>& motions, const TimeGrid& grid);

}  // namespace desmo
