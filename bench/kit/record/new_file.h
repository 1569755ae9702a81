#pragma once

#include <fstream>
#include <string>

namespace desmo::bench {

/// A file that appears whole or not at all, unless its path is a device or a pipe, which is written
/// to as it is.
class NewFile {
 public:
  /// Opens what will become the file, so that an unusable path is known before the work is done.
  /// Throws std::runtime_error, naming the path.
  explicit NewFile(const std::string& path);
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  /// Removes what is unfinished unless write() has succeeded.
  ~NewFile();

  /// Once. Throws std::runtime_error, naming the path.
  void write(const std::string& text);

 private:
  std::string path_;        // links followed
  std::string unfinished_;  // empty when written to directly
  std::ofstream out_;
};

}  // namespace desmo::bench
