// The part of a record that holds the table of extremes.
#pragma once

#include "report/json_node.h"
#include "report/record.h"

namespace desmo::report {

/// Reads `extreme_rows` and `extremes`, where there are any: each row, and each of its cases in
/// each formulation, once. Throws InvalidRecord.
void read_extremes(Record& record, const JsonNode& root);

}  // namespace desmo::report
