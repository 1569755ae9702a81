#pragma once

#include "cases/mechanism/level.h"
#include "cases/mechanism/motion.h"

namespace desmo {

/// Returns whether a motion's rate may be 0 at a time [s]: whether 0 is in its enclosure, for which
/// the motion's numbers count with their remainders, and the time within two units of its rounding.
/// So an instant start + i step meets the rest that it is meant to.
/// - level: of the rate: velocity or acceleration
bool vanishes(const Motion& motion, double time, Level level);

}  // namespace desmo
