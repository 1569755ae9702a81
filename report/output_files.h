// Writing a set of files so that nothing half-written is ever seen under a file's name.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <vector>

#include "report/formats/formats.h"

namespace desmo::report {

/// A file that could not be written. The message names it and the reason.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Creates `folder` where needed and writes every file beside its final name, then renames them.
/// When one cannot be written completely, none is renamed, what was begun is removed, and
/// OutputError is thrown.
void write_files(const std::filesystem::path& folder, const std::vector<Rendered>& files);

/// The whole text to standard output, or OutputError.
void write_standard_output(const std::string& text);

}  // namespace desmo::report
