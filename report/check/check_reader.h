// From a results file to a CheckRecord.
#pragma once

#include <filesystem>
#include <string_view>

#include "report/check/check_record.h"
#include "report/read/json_node.h"

namespace desmo::report {

/// Checks everything that a verdict relies on: that both sides have the same candidates, and that
/// what is right on both was measured by all that was used, Time, Work or both. The two sides are
/// records of their own, read as such. Throws InvalidRecord, naming the place; UnsupportedVersion
/// and MixedRecord where they apply.
CheckRecord parse_check(std::string_view text);

/// Likewise, of what has been parsed already.
CheckRecord read_check(const JsonNode& root);

/// Throws as parse_check, or UnreadableFile.
CheckRecord read_check(const std::filesystem::path& file);

}  // namespace desmo::report
