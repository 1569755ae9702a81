#pragma once

#include "formulations/modelling/equations/equation_writer.h"

namespace desmo {

/// The definitions of all relative coordinates, in D dimensions. Throws std::invalid_argument,
/// naming the coordinate, for one that its own definition contradicts in the nominal position, or
/// that has none.
template <int D>
void write_coordinate_equations(EquationWriter& writer);

}  // namespace desmo
