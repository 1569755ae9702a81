// desmo_report as a user runs it, in a folder of its own that goes when the test ends.
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

  /// desmo_report with these arguments.
  int report(const std::string& arguments);

  /// desmo_report tables on a record of tests/report/data or, by its whole path, of elsewhere.
  int tables(const std::filesystem::path& record, const std::string& options = "");

  /// By name; none when there is no such folder.
  static std::map<std::string, std::string> files_in(const std::filesystem::path& folder);

  std::filesystem::path folder_;
  std::string out_, err_;
};

}  // namespace desmo::report
