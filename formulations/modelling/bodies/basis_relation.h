#pragma once

#include <string>

#include "formulations/modelling/equations/equation_writer.h"

namespace desmo {

/// Writes that a point of a body, not of its basis, follows from the basis; equation_prefix: what
/// the equation's name begins with.
void relate_point(EquationWriter& writer, const std::string& equation_prefix, const RigidBody& body,
                  int point);

/// The same of a vector.
void relate_vector(EquationWriter& writer, const std::string& equation_prefix,
                   const RigidBody& body, int vector);

}  // namespace desmo
