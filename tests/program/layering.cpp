// The arrows of the design go one way: cases → formulations → bench; report stands on results
// alone; the JSON library stays in .cpp files.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>

namespace desmo::layering_test {
namespace {

namespace fs = std::filesystem;

const fs::path source_dir = DESMO_SOURCE_DIR;

TEST(Layering, IncludesFollowTheDesign) {
  const std::map<std::string, std::set<std::string>> allowed = {
      {"cases", {"cases"}},
      {"formulations", {"cases", "formulations"}},
      {"bench", {"cases", "formulations", "bench"}},
      {"report", {"report"}},
  };
  const std::set<std::string> folders{"cases", "formulations", "bench", "report", "tests"};
  int includes = 0;
  for (const auto& [folder, may_include] : allowed)
    for (const auto& file : fs::recursive_directory_iterator(source_dir / folder)) {
      const std::string extension = file.path().extension().string();
      if (extension != ".h" && extension != ".cpp") continue;
      std::ifstream in(file.path());
      for (std::string line; std::getline(in, line);) {
        if (!line.starts_with("#include \"")) continue;
        const std::string path = line.substr(10, line.rfind('"') - 10);
        const std::string target = path.substr(0, path.find('/'));
        if (!folders.contains(target)) continue;  // a generated or third-party header
        ++includes;
        EXPECT_TRUE(may_include.contains(target)) << file.path() << " includes " << path;
      }
    }
  EXPECT_GT(includes, 50);
}

TEST(Layering, JsonStaysInSourceFiles) {
  for (const char* folder : {"cases", "formulations", "bench", "report"})
    for (const auto& file : fs::recursive_directory_iterator(source_dir / folder)) {
      if (file.path().extension() != ".h") continue;
      std::ifstream in(file.path());
      for (std::string line; std::getline(in, line);)
        EXPECT_EQ(line.find("nlohmann/json.hpp"), std::string::npos) << file.path();
    }
}

}  // namespace
}  // namespace desmo::layering_test
