#pragma once

#include "cases/mechanism/description.h"

namespace desmo {

/// Throws std::invalid_argument, naming the body, where the square of a length on it over- or
/// underflows in double precision: equations hold such squares.
void require_representable(const Description& description);

}  // namespace desmo
