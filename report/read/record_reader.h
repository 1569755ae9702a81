// Reading of a results file's text as a Record.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "report/read/record.h"
#include "report/read/record_file.h"

namespace desmo::report {

/// Checks everything the report relies on: the schema's name and major version, required keys,
/// types, times above zero, the verification of every "ok" candidate and request, as many samples
/// as it says, nothing given twice, one machine, one model for each case and size with one set of
/// results. An "ok" candidate or request that exceeds `record.settings.allowed` becomes a failed
/// one that says so and has no time. Unknown keys are ignored, so that a record with a newer minor
/// version is read. Throws InputError, or MixedRecord.
Record parse_record(std::string_view text, const std::string& file = "record");

/// Likewise, of what has been parsed already, alone or inside another document.
Record read_record(const RecordValue& root);

/// Reads at most max_file bytes and parses them. Throws as parse_record.
Record read_record(const std::filesystem::path& file);

}  // namespace desmo::report
