#pragma once

#include <string>

#include "formulations/modelling/equations/equation_writer.h"

namespace desmo {

/// Writes the linear equation by which a body's point follows from the body's basis (see Basis).
/// The point must not be in the basis. equation_prefix: beginning of the equation's name.
void relate_point(EquationWriter& writer, const std::string& equation_prefix, const RigidBody& body,
                  int point);

/// Writes the same equation for a vector.
void relate_vector(EquationWriter& writer, const std::string& equation_prefix,
                   const RigidBody& body, int vector);

}  // namespace desmo
