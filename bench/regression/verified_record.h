#pragma once

#include <string>
#include <vector>

namespace desmo::regression {

/// Verifies cells against the quadruple reference over their first instants, 10 ms apart, and says
/// so in a record as results/record.schema.json defines it, but without samples. Cells that this
/// build does not have are "not_run".
std::string verified_record(int instants, const std::vector<std::string>& cells);

}  // namespace desmo::regression
