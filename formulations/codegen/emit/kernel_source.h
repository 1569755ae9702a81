#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "formulations/codegen/record/recording.h"
#include "formulations/structure/part_type.h"

namespace desmo::generate {

/// Writes the functions of the kernel of a group type, and its entry lists, as C++ in a
/// namespace of that name. See Kernel for what they do. The same type and samples give the same
/// bytes.
void write_kernel(std::ostream& out, const std::string& name, const PartType& type,
                  const std::vector<SamplePoint>& samples);

/// Writes the table row of a kernel already written.
void write_table_row(std::ostream& out, const std::string& name, const PartType& type);

}  // namespace desmo::generate
