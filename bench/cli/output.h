// Where results go: a file that appears whole or not at all, or standard output.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "bench/cli/interruption.h"

namespace desmo::cli {

/// An output that is opened before the work is done, so that an unusable path is known at once.
/// A regular file is written beside its final name and renamed by finish(); without that, it
/// leaves nothing behind, not even when interrupted. Devices and pipes are written to as they are.
/// All throw Error (unwritable_output), naming the path and the reason, or OutputClosed.
class Output {
 public:
  /// "" and "-": standard output. Links are followed; a file that exists keeps its permissions.
  explicit Output(const std::string& path);
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  ~Output();

  void write(std::string_view text);
  /// Nothing may be written after it.
  void finish();

  bool is_standard_output() const { return path_.empty(); }
  int descriptor() const { return file_; }

 private:
  void open();
  [[noreturn]] void fail(int error) const;

  std::string path_;        // as it was given, for messages; empty: standard output
  std::string target_;      // links followed
  std::string unfinished_;  // empty when written to directly
  std::optional<RemovedWhenInterrupted> guard_;
  int file_ = -1;
};

/// The whole text to standard output.
void write_standard_output(std::string_view text);

}  // namespace desmo::cli
