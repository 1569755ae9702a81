#pragma once

#include <memory>

#include "formulations/parts/newton_part.h"

namespace desmo {

/// Makes a part solved in single precision, by a backend that offers it: what it reads of the state
/// is rounded, and what it finds are single numbers, kept in the double ones of the state. Its
/// equations are automatic; context.single holds its state.
std::unique_ptr<Part> make_single_precision_part(const PartContext& context,
                                                 const Backend& backend);

}  // namespace desmo
