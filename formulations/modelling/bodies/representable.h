#pragma once

#include "cases/mechanism/mechanism.h"

namespace desmo {

/// Throws std::invalid_argument, naming the body, when the square of a length on a body over- or
/// underflows in double precision. Equations contain such squares.
void require_representable(const Mechanism& mechanism);

}  // namespace desmo
