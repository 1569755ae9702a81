#pragma once

#include <string>

#include "cases/mechanism/motion.h"

namespace desmo::cli {

/// Appends the shortest decimal number that reads back as this double; of −0 that of 0.
void append_number(double value, std::string& text);

/// Appends a time [s] as it was asked for: of the i-th instant, start + i step in decimal
/// arithmetic, rounded once, where the double has the rounding of `step` i times. Of a time that is
/// none of the grid's instants, appends the number.
void append_time(double time, const TimeGrid& grid, std::string& text);

}  // namespace desmo::cli
