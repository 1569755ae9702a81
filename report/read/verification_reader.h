// The parts of a record that say whether an answer is right.
#pragma once

#include "report/read/json_node.h"
#include "report/read/verification.h"

namespace desmo::report {

/// Both throw InvalidRecord.
Status read_status(const JsonNode& node);
Verification read_verification(const JsonNode& node);

}  // namespace desmo::report
