#pragma once

#include "cases/mechanism/mechanism.h"

namespace desmo {

/// Throws std::invalid_argument, naming the body, where the square of a length on it over- or
/// underflows in double precision: equations hold such squares.
void require_representable(const Mechanism& mechanism);

}  // namespace desmo
