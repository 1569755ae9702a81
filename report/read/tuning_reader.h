// The part of a record that holds what the choices of desmo tune are worth.
#pragma once

#include "report/read/json_node.h"
#include "report/read/record.h"

namespace desmo::report {

/// Reads `tuning` of the section `accuracy`, where there is any: each mechanism and error once.
/// Throws InvalidRecord.
void read_tuning(Record& record, const JsonNode& section);

}  // namespace desmo::report
