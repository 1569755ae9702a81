// From a file to a JSON document that can be trusted to be one.
#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

namespace desmo::report {

inline constexpr const char* schema_version = "2.0.0";       ///< the one that is read
inline constexpr std::size_t max_record = 64 * 1024 * 1024;  ///< bytes
inline constexpr int max_nesting = 32;

/// A results file that cannot be read or is not a valid record. The message names the place in the
/// document (`paper.candidates[3].time.seconds[0]: ...`); the caller adds the name of the file.
class InvalidRecord : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A record put together from measurements that do not belong together.
class MixedRecord : public InvalidRecord {
 public:
  using InvalidRecord::InvalidRecord;
};

/// A record of another schema version.
class UnsupportedVersion : public InvalidRecord {
 public:
  using InvalidRecord::InvalidRecord;
};

/// There is no such file, or it may not be read.
class UnreadableFile : public InvalidRecord {
 public:
  using InvalidRecord::InvalidRecord;
};

class JsonNode;

/// Reads the text of a file, compressed by gzip or not: at most max_record bytes. Throws
/// UnreadableFile, or InvalidRecord when there are more or the compressed data are damaged.
std::string read_whole(const std::filesystem::path& file);

/// Refuses what a parser would accept and the report must not: a key given twice, and nesting
/// without end. Throws InvalidRecord.
nlohmann::json parse_json(std::string_view text);

/// Throws InvalidRecord when a document is not of this schema, and UnsupportedVersion, with how to
/// make it anew, when it is not of schema_version.
void check_schema(const JsonNode& root, const std::string& name);

}  // namespace desmo::report
