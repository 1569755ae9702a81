// Output of results: a file that appears completely or not at all, or standard output.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "bench/cli/interruption.h"

namespace desmo::cli {

/// Output that is opened before the work is done, so that an unusable path is known at once. A
/// regular file is written next to its final name, and finish() renames it. Without finish()
/// nothing remains, even after an interruption. Devices and pipes are written directly. All
/// functions throw Error (unwritable_output), naming the path and the reason, or OutputClosed.
class Output {
 public:
  /// Opens a path; "" and "-" are standard output. Follows links; an existing file keeps its
  /// permissions.
  explicit Output(const std::string& path);
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  ~Output();

  void write(std::string_view text);
  /// Completes the output; nothing may be written afterwards.
  void finish();

  bool is_standard_output() const { return path_.empty(); }
  int descriptor() const { return file_; }

 private:
  void open();
  [[noreturn]] void fail(int error) const;

  std::string path_;        // path as given, for messages; empty: standard output
  std::string target_;      // path with links followed
  std::string unfinished_;  // temporary name; empty when written directly
  std::optional<RemovedWhenInterrupted> guard_;
  int file_ = -1;
};

/// Writes the whole text to standard output.
void write_standard_output(std::string_view text);

}  // namespace desmo::cli
