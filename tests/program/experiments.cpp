// An experiment has one name, which each list of experiments has: programs, records, documents.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include "tests/started.h"

namespace desmo::experiments_test {
namespace {

namespace fs = std::filesystem;

const fs::path source_dir = DESMO_SOURCE_DIR;

/// A list of all experiments.
struct List {
  const char* file;
  const char* entry;       ///< text that each experiment has, with NAME for its name
  const char* begin = "";  ///< text with which the list begins; it ends at a blank line
};

constexpr List lists[] = {
    {"bench/experiments/experiments.h", "\nnamespace desmo::NAME {\n"},
    {"bench/experiments/main.cpp", "\n    {\"NAME\", ", " all_experiments[] = {"},
    {"bench/run", "\n#   NAME  "},
    {"bench/README.md", "\n- [`NAME`](experiments/NAME/README.md): "},
    {"results/record.schema.json", "\n    \"NAME\": {\n"},
    {"results/record.schema.json", "{\"required\": [\"NAME\"]}", "\n  \"anyOf\": "},
    {"results/README.md", "\n- `NAME`: "},
    {"report/read/readers.h", "\n    {\"NAME\", ", " experiments[] = {"},
    {"report/report.cpp", "\n    {\"NAME\", ", " sections_of[] = {"},
    {"report/text/texts.txt", "\nNAME = ", "\n[experiments]"},
    {"tests/records/bench.cpp", "\"NAME\"", ", HasEveryExperimentByItsName) {"},
};

/// Returns the experiments that have a folder.
std::set<std::string> names() {
  std::set<std::string> found;
  for (const auto& folder : fs::directory_iterator(source_dir / "bench/experiments"))
    if (fs::exists(folder.path() / "run.cpp")) found.insert(folder.path().filename().string());
  return found;
}

TEST(Experiments, AreInEveryList) {
  ASSERT_TRUE(names().contains("paper"));
  for (const auto& [file, entry, begin] : lists) {
    std::string text = text_of(source_dir / file);
    const std::size_t first = text.find(begin);
    ASSERT_NE(first, text.npos) << file << " has no list that begins with " << begin;
    text.erase(0, first);
    if (*begin) text.resize(std::min(text.find("\n\n"), text.size()));
    for (const std::string& name : names()) {
      const std::string wanted = std::regex_replace(entry, std::regex("NAME"), name);
      EXPECT_TRUE(text.find(wanted) != text.npos) << file << " lacks " << wanted;
    }
  }
}

}  // namespace
}  // namespace desmo::experiments_test
