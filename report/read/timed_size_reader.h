// The parts of a record that hold time against size.
#pragma once

#include "report/read/json_node.h"
#include "report/read/record.h"

namespace desmo::report {

/// Reads the section `size`, `growth` and `break_even`: each case, size and formulation once. What
/// exceeds `record.settings.allowed`, which grows as an entry's tolerance, becomes failed and has
/// no time. Throws InvalidRecord.
void read_sizes(Record& record, const JsonNode& section);

}  // namespace desmo::report
