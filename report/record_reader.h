// From the text of a results file to a Record.
#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include "report/record.h"

namespace desmo::report {

inline constexpr int supported_major = 1;                        ///< of the schema's version
inline constexpr std::size_t largest_record = 64 * 1024 * 1024;  ///< bytes
inline constexpr int deepest_nesting = 32;

/// A results file that cannot be read or is not a valid record. The message names the place in the
/// document (`cells[3].cpu_seconds[0]: ...`); the caller adds the name of the file.
class InvalidRecord : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A record put together from measurements that do not belong together.
class MixedRecord : public InvalidRecord {
 public:
  using InvalidRecord::InvalidRecord;
};

/// Checks everything the report relies on: the schema's name and major version, required keys,
/// types, times above zero, the verification of every "ok" cell and request, as many samples as it
/// says, nothing given twice, one machine, one model for each case and size with one set of
/// results. An "ok" cell or request that exceeds `record.settings.allowed` becomes a failed one
/// that says so and has no time. Unknown keys are ignored, so that a record with a newer minor
/// version is read. Throws InvalidRecord, or MixedRecord.
Record parse_record(std::string_view text);

/// Reads at most largest_record bytes and parses them. Throws as parse_record.
Record read_record(const std::filesystem::path& file);

}  // namespace desmo::report
