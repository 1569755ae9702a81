// The part of a record that holds time against error.
#pragma once

#include "report/read/json_node.h"
#include "report/read/record.h"

namespace desmo::report {

/// Reads `floors` and `points` of the section `accuracy`, where there are any. Everything is
/// checked that the report relies on: known status, ids that can be taken apart, samples and errors
/// of every "ok" point, limits with their condition number, nothing given twice, no point without
/// the floor of its series. An "ok" point without an error of position, beyond all measure, becomes
/// a failed one. Throws InvalidRecord.
void read_points(Record& record, const JsonNode& section);

}  // namespace desmo::report
