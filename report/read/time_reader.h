// Times of a record: samples by a clock.
#pragma once

#include <string_view>
#include <vector>

#include "report/read/json_node.h"
#include "report/read/record.h"
#include "report/read/time.h"

namespace desmo::report {

/// Reads "cpu" or "wall". Throws InvalidRecord.
Clock read_clock(const JsonNode& node);

/// Reads the time of a whole analysis: its clock, its samples, and by the CPU clock its timing
/// windows, where the settings have some.
///
/// Throws InvalidRecord, also when the clock is not the one that `id` is measured by.
Time read_time(const JsonNode& node, const Settings& settings, std::string_view id);

/// Reads the samples of a time that has to be of the CPU clock, at least one. Throws InvalidRecord.
std::vector<double> read_cpu_seconds(const JsonNode& node);

}  // namespace desmo::report
