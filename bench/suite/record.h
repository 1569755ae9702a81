#pragma once

#include <fstream>
#include <string>
#include <vector>

#include "bench/suite/timed.h"

namespace desmo::suite {

/// What the record holds beside what was timed.
struct Run {
  std::string date;     ///< UTC, when it began
  std::string command;  ///< program name and arguments
  std::vector<double> load_before, load_after;
};

/// The file of the results record (results/record.schema.json). It appears whole or not at all,
/// unless the path is a device or a pipe, which is written to as it is.
class RecordFile {
 public:
  /// Opens what will become the file, so that an unusable path is known before the work is done.
  /// Throws std::runtime_error, naming the path.
  explicit RecordFile(const std::string& path);
  RecordFile(const RecordFile&) = delete;
  RecordFile& operator=(const RecordFile&) = delete;
  /// Leaves nothing behind unless write() has succeeded.
  ~RecordFile();

  /// Writes the record of these, at least one; all have the same time grid. Throws
  /// std::runtime_error, naming the path.
  void write(const Run& run, const std::vector<Timed*>& timed);

 private:
  std::string path_;        // links followed
  std::string unfinished_;  // empty when written to directly
  std::ofstream out_;
};

}  // namespace desmo::suite
