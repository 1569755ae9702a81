#pragma once

#include "cases/io/format.h"
#include "cases/mechanism/mechanism.h"
#include "cases/mechanism/motion.h"

namespace desmo {

/// Reads the motion of one coordinate, in metres (or the mechanism's free unit) or radians.
/// Complains where it needs a unit that is open.
Motion read_motion(const JsonValue& value, Mechanism::CoordinateType coordinate,
                   const Units& units);

/// `motion` of a scene: one for each driven coordinate, in the description's order. Those that
/// `known` has already (all, or none) may be left out.
std::vector<Motion> read_motions(const JsonValue& root, const Mechanism& mechanism,
                                 const Units& units, std::vector<Motion> known);

/// Complains when a table does not cover the instants. Motions as read_motions returned them.
void check_tables(const JsonValue& root, const Mechanism& mechanism,
                  const std::vector<Motion>& motions, const TimeGrid& grid);

}  // namespace desmo
