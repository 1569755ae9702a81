#pragma once

#include "formulations/modelling/equations/equation_writer.h"

namespace desmo {

/// Writes the definitions of all relative coordinates, in D dimensions. Throws
/// std::invalid_argument, naming the coordinate, when a definition does not fit the nominal
/// position or cannot be written.
template <int D>
void write_coordinate_equations(EquationWriter& writer);

}  // namespace desmo
