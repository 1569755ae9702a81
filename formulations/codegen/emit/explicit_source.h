#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "formulations/codegen/order/explicit_order.h"
#include "formulations/structure/part_type.h"

namespace desmo::generate {

/// Writes the functions of the explicit kernel of a type as C++ in a namespace of that name. See
/// ExplicitKernel for what they do. The same type and samples give the same bytes.
void write_explicit_kernel(std::ostream& out, const std::string& name, const PartType& type,
                           const std::vector<SamplePoint>& samples);

/// Writes the table row of a kernel already written.
void write_explicit_table_row(std::ostream& out, const std::string& name, const PartType& type);

/// The same for what lanes of parts need beside.
void write_lane_table_row(std::ostream& out, const std::string& name, const PartType& type);

}  // namespace desmo::generate
