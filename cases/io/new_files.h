// Writers of files: nothing half-written is ever seen under the name of a regular file.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace desmo {

/// Error of an output that could not be written. The message names the output and the reason.
class OutputError : public std::runtime_error {
 public:
  explicit OutputError(const std::string& message, int code = 0)
      : std::runtime_error(message), code_(code) {}
  int code() const { return code_; }  ///< errno of the failure; 0: unknown

 private:
  int code_;
};

/// An output that is opened before the work is done, so that an unusable path is known at once. A
/// regular file is written under a temporary name in its folder, and finish() renames it; without
/// finish() nothing of it remains. Devices and pipes are written directly. Functions that fail
/// throw OutputError.
class OutputFile {
 public:
  /// Opens a path; "" and "-" are standard output. Follows links, also to a file that does not
  /// exist yet. An existing file keeps its permissions.
  /// - begun: function that is called with the temporary name of a regular file, before a file of
  ///   that name is created; may be null
  explicit OutputFile(const std::string& path, void (*begun)(const std::string& name) = nullptr);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  void write(std::string_view text);
  /// Completes the output and closes it, except for standard output. Nothing may be written
  /// afterwards.
  void finish();

  bool is_standard_output() const { return path_.empty(); }

 private:
  friend void write_files(const std::filesystem::path&, const std::vector<struct NewFile>&);
  OutputFile() = default;
  void open(void (*begun)(const std::string&));
  void close();
  void rename();
  [[noreturn]] void fail(int error) const;

  std::string path_;        // path as given, for messages; empty: standard output
  std::string target_;      // path with links followed
  std::string unfinished_;  // temporary name; empty when written directly, or renamed
  int file_ = -1;           // descriptor of the open file; -1: closed
};

/// A file to be written: its name, without a folder, and all that it holds.
struct NewFile {
  std::string file_name;
  std::string content;
};

/// Creates `folder` where needed and writes every file under a temporary name, then renames them.
/// Throws OutputError. When one cannot be written completely, none is renamed, and the temporary
/// files are removed. When a renaming fails, the files before it have their final names.
void write_files(const std::filesystem::path& folder, const std::vector<NewFile>& files);

/// Writes the whole text to standard output. Throws OutputError.
void write_standard_output(std::string_view text);

}  // namespace desmo
