// The part of a record that holds what the choices of desmo tune are worth.
#pragma once

#include "report/json_node.h"
#include "report/record.h"

namespace desmo::report {

/// Reads `promises`, where there are any: each mechanism and error once. Throws InvalidRecord.
void read_promises(Record& record, const JsonNode& root);

}  // namespace desmo::report
