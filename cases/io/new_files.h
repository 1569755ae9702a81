// The writer of files: nothing half-written is ever seen under a file's name.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace desmo {

/// A file to be written: its name, without a folder, and all that it holds.
struct NewFile {
  std::string file_name;
  std::string content;
};

/// A file that could not be written. The message names it and the reason.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Creates `folder` where needed and writes every file under a temporary name, then renames them.
/// When one cannot be written completely, none is renamed, what was begun is removed, and
/// OutputError is thrown.
void write_files(const std::filesystem::path& folder, const std::vector<NewFile>& files);

/// Writes the whole text to standard output. Throws OutputError.
void write_standard_output(std::string_view text);

}  // namespace desmo
