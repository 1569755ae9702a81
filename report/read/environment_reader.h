// What a record says of machine, build and settings.
#pragma once

#include "report/read/json_node.h"
#include "report/read/record.h"

namespace desmo::report {

// All throw InvalidRecord, naming the place.
Machine read_machine(const JsonNode& node);    ///< `record.machine`
Build read_build(const JsonNode& node);        ///< `record.build`
Settings read_settings(const JsonNode& node);  ///< `record.settings`

}  // namespace desmo::report
