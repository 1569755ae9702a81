#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "tests/started.h"

namespace desmo::dependencies_test {
namespace {

const std::filesystem::path source_dir = DESMO_SOURCE_DIR;

/// Returns the Debian packages that bench/setup installs, without the tools that every build has.
std::set<std::string> debian_packages() {
  const std::set<std::string> tools{"g++",    "cmake", "ninja-build", "git", "ca-certificates",
                                    "nodejs", "npm"};
  std::set<std::string> packages;
  const std::string setup = text_of(source_dir / "bench/setup");
  const std::regex list("(?:^|\n) *[a-z]+=\\(([^)$]*)");
  for (std::sregex_iterator it(setup.begin(), setup.end(), list), end; it != end; ++it) {
    std::istringstream words((*it)[1]);
    for (std::string word; words >> word;)
      if (!tools.contains(word)) packages.insert(word);
  }
  return packages;
}

TEST(Dependencies, EachPackageHasItsLicenceAndPurpose) {
  std::set<std::string> packages = debian_packages();
  ASSERT_TRUE(packages.contains("libeigen3-dev") && packages.contains("libceres-dev"));
  for (const char* file : {"report/figures/package.json", "bench/cli/view/package.json"}) {
    const nlohmann::json package = nlohmann::json::parse(text_of(source_dir / file));
    for (const auto& [name, version] : package.at("dependencies").items()) packages.insert(name);
  }
  std::istringstream page(text_of(source_dir / "bench/dependencies.md"));
  std::set<std::string> described;
  const std::regex name("`([^`]+)`");
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("| `")) continue;
    const std::string first_cell = line.substr(0, line.find(" | "));
    for (std::sregex_iterator it(first_cell.begin(), first_cell.end(), name), end; it != end; ++it)
      described.insert((*it)[1]);
  }
  EXPECT_EQ(described, packages);
}

}  // namespace
}  // namespace desmo::dependencies_test
