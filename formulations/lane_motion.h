#pragma once

#include <span>

#include "cases/motion.h"

namespace desmo {

/// z, ż and z̈ of a motion at several times (s), a multiple of four: at each what sample() gives,
/// but for rounding.
void sample_lanes(const Motion& motion, std::span<const double> times, double* position,
                  double* velocity, double* acceleration);

}  // namespace desmo
