#pragma once

#include <ostream>
#include <string>

#include "formulations/codegen/record/recording.h"
#include "formulations/model/part_type.h"

namespace desmo::generate {

/// Writes the functions and entry lists of a type's kernel (see Kernel) as C++ in a namespace of
/// its name. The same type and samples give the same bytes.
void write_kernel(std::ostream& out, const SampledType& type);

/// Writes the Kernel of a kernel already written, as a table row.
void write_table_row(std::ostream& out, const std::string& name, const PartType& type);

/// Writes the functions of a type's explicit kernel (see ExplicitKernel) as C++ in a namespace of
/// its name. The same type and samples give the same bytes.
void write_explicit_kernel(std::ostream& out, const SampledType& type);

/// Writes the ExplicitKernel of a kernel already written, as a table row.
void write_explicit_table_row(std::ostream& out, const std::string& name, const PartType& type);

/// Writes the LaneKernel of a kernel already written, as a table row.
void write_lane_table_row(std::ostream& out, const std::string& name, const PartType& type);

}  // namespace desmo::generate
