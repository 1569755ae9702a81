// The part of a record that holds the table of extremes.
#pragma once

#include "report/read/json_node.h"
#include "report/read/record.h"

namespace desmo::report {

/// Reads the section `extremes`, `rows` and `results`: each row, and each of its cases in each
/// formulation, once. Throws InvalidRecord.
void read_extremes(Record& record, const JsonNode& section);

}  // namespace desmo::report
