#pragma once

#include "formulations/modelling/equations/equation_writer.h"

namespace desmo {

/// Writes the equations of joints between different rigid bodies: offsets of planar sliding joints
/// whose distance is not declared, and angles of universal joints. Shared points and vectors and
/// relative coordinates imply all others.
void write_joint_equations(EquationWriter& writer);

}  // namespace desmo
