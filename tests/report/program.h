// A fixture that runs desmo_report as a user does, in a temporary folder.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>

namespace desmo::report {

class Program : public ::testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  /// Runs a shell command and gives its exit code; its streams end up in out_ and err_.
  int shell(const std::string& command);

  /// Writes a file of the folder. Returns its path.
  std::string write(const std::string& name, const std::string& text);

  /// Runs desmo_report with these arguments.
  int report(const std::string& arguments);

  /// Runs desmo_report tables on a record: a name in tests/report/data, or an absolute path.
  int tables(const std::filesystem::path& record, const std::string& options = "");

  /// Returns the contents of a folder's files by name; empty when the folder does not exist.
  static std::map<std::string, std::string> files_in(const std::filesystem::path& folder);

  std::filesystem::path folder_;
  std::string out_, err_;
};

}  // namespace desmo::report
