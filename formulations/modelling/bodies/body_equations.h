#pragma once

#include "formulations/modelling/equations/equation_writer.h"

namespace desmo {

/// The equations within bodies of D dimensions: vectors of the ground that are coordinates are
/// held; every other body keeps the products of its basis, and all else that it carries is a linear
/// function of it (basis_relation.h).
template <int D>
void write_body_equations(EquationWriter& writer);

}  // namespace desmo
