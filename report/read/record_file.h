// Reading of a file as a JSON document of a known schema.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "cases/io/input_error.h"
#include "report/read/record_value.h"
#include "results/schema_version.h"

namespace desmo::report {

// Results files that cannot be read throw InputError, whose message names file and place.

/// Error of a record with measurements that do not belong together.
class MixedRecord : public InputError {
 public:
  using InputError::InputError;
};

/// Error of a document whose major schema version is not read.
class UnsupportedVersion : public InputError {
 public:
  using InputError::InputError;
};

/// Reads the text of a file, compressed by gzip or not. Throws UnreadableFile, naming the file,
/// when it cannot be read or has more than max_file bytes, and InputError when it decompresses to
/// more, or is damaged.
std::string read_record_text(const std::filesystem::path& file);

/// Parses a text and calls read() with its root. Adds the file to the message of a MixedRecord.
template <class Read>
auto read_document(std::string_view text, const std::string& file, const Read& read) {
  const JsonDocument document(text, file);
  try {
    return read(RecordValue(document.root()));
  } catch (const MixedRecord& error) {
    throw MixedRecord(file + ": " + error.what());
  }
}

/// Throws InputError when a document is not of the schema of that name, or has no version such as
/// 2.0.0. Throws UnsupportedVersion, with what to do, when its major version is neither
/// schema_version's nor the one before.
void check_schema(const RecordValue& root, const std::string& name);

/// Returns a note when a version is newer than schema_version; empty when it is not.
std::string note_on_version(const std::string& version);

}  // namespace desmo::report
