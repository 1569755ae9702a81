// The writer of files: nothing half-written is ever seen under a file's name.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace desmo {

/// An output that could not be written. The message names it and the reason.
class OutputError : public std::runtime_error {
 public:
  explicit OutputError(const std::string& message, int code = 0)
      : std::runtime_error(message), code_(code) {}
  int code() const { return code_; }  ///< errno, or 0

 private:
  int code_;
};

/// Output that is opened before the work is done, so that an unusable path is known at once. A
/// regular file is written next to its final name, and finish() renames it; without finish()
/// nothing remains. Devices and pipes are written directly. All functions throw OutputError.
class OutputFile {
 public:
  /// Opens a path; "" and "-" are standard output. Follows links, also to a file that is yet to be;
  /// an existing file keeps its permissions. begun: is called with the name under which a file is
  /// written, before it exists.
  explicit OutputFile(const std::string& path, void (*begun)(const std::string& name) = nullptr);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  void write(std::string_view text);
  /// Completes the output; nothing may be written afterwards.
  void finish();

  bool is_standard_output() const { return path_.empty(); }

 private:
  friend void write_files(const std::filesystem::path&, const std::vector<struct NewFile>&);
  OutputFile() = default;
  void open(void (*begun)(const std::string&));
  void close();
  void rename();
  [[noreturn]] void fail(int error) const;

  std::string path_;        // as given, for messages; empty: standard output
  std::string target_;      // path with links followed
  std::string unfinished_;  // temporary name; empty when written directly
  int file_ = -1;
};

/// A file to be written: its name, without a folder, and all that it holds.
struct NewFile {
  std::string file_name;
  std::string content;
};

/// Creates `folder` where needed and writes every file under a temporary name, then renames them.
/// When one cannot be written completely, none is renamed, what was begun is removed, and
/// OutputError is thrown.
void write_files(const std::filesystem::path& folder, const std::vector<NewFile>& files);

/// Writes the whole text to standard output. Throws OutputError.
void write_standard_output(std::string_view text);

}  // namespace desmo
