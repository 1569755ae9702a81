#pragma once

#include "formulations/modelling/equations/equation_writer.h"

namespace desmo {

/// Writes the equations within the bodies of a D-dimensional mechanism. Ground vectors that are
/// coordinates are held constant. Every other body keeps the scalar products of its basis; its
/// other points and vectors are linear functions of the basis (basis_relation.h).
template <int D>
void write_body_equations(EquationWriter& writer);

}  // namespace desmo
