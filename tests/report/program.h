// A fixture that runs desmo_report as a user does, in a temporary folder.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "cases/io/text_file.h"
#include "tests/report/sample.h"
#include "tests/started.h"

namespace desmo::report {

class Program : public InFolder {
 protected:
  /// Runs desmo_report with these arguments.
  int report(const std::string& arguments) {
    return shell(std::string(DESMO_REPORT_PROGRAM) + " " + arguments);
  }

  /// Runs desmo_report tables on a record: a name in tests/report/data, or an absolute path.
  int tables(const std::filesystem::path& record, const std::string& options = "") {
    return report("tables " + data_file(record).string() + " " + options);
  }

  /// Returns the contents of a folder's files by name; empty when the folder does not exist.
  static std::map<std::string, std::string> files_in(const std::filesystem::path& folder) {
    std::map<std::string, std::string> files;
    if (std::filesystem::exists(folder))
      for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.is_regular_file()) files[entry.path().filename()] = read_text(entry.path());
    return files;
  }
};

}  // namespace desmo::report
