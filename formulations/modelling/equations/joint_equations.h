#pragma once

#include "formulations/modelling/equations/equation_writer.h"

namespace desmo {

/// The equations of the joints between different rigid bodies that neither shared entities nor a
/// relative coordinate state: offsets of plane sliding joints, angles of universal joints.
void write_joint_equations(EquationWriter& writer);

}  // namespace desmo
