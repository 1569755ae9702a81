// The arrows of the design go one way: cases → formulations → bench; report stands on results
// and on the readers and writers of cases/io; the JSON library stays in .cpp files.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace desmo::layering_test {
namespace {

namespace fs = std::filesystem;

const fs::path source_dir = DESMO_SOURCE_DIR;

/// A folder may include itself and those before it; report none but itself and the readers and
/// writers of cases/io. `formulation.h` is the interface that `motion` implements; the other files
/// at the door stand after codegen.
TEST(Layering, FoldersIncludeOnlyThoseBeforeThemAndHeadersNoJson) {
  const std::vector<std::string> order = {"cases/numbers",
                                          "cases/mechanism",
                                          "cases/generators",
                                          "cases/library",
                                          "cases/io",
                                          "cases/extremes",
                                          "formulations/constraints",
                                          "formulations/base",
                                          "formulations/model",
                                          "formulations/modelling",
                                          "formulations/equations",
                                          "formulations/algebra",
                                          "formulations/parts",
                                          "formulations/formulation.h",
                                          "formulations/motion",
                                          "formulations/batch",
                                          "formulations/codegen",
                                          "formulations",
                                          "formulations/verification",
                                          "formulations/verification/certificate",
                                          "formulations/verification/branch",
                                          "formulations/verification/run",
                                          "formulations/verification/range",
                                          "formulations/runtime",
                                          "bench/kit",
                                          "bench/peers",
                                          "bench/regression",
                                          "bench/experiments",
                                          "bench/cli",
                                          "report/text",
                                          "report/read",
                                          "report/statistics",
                                          "report/tables",
                                          "report/figures",
                                          "report/formats",
                                          "report/check",
                                          "report"};
  const auto rank = [&](const std::string& file) {  // of the longest entry that it stands in
    std::size_t best = order.size(), length = 0;
    for (std::size_t i = 0; i < order.size(); ++i)
      if ((file == order[i] || file.starts_with(order[i] + "/")) && order[i].size() > length) {
        best = i;
        length = order[i].size();
      }
    return best;
  };
  int includes = 0;
  for (const char* top : {"cases", "formulations", "bench", "report"})
    for (const auto& file : fs::recursive_directory_iterator(source_dir / top)) {
      const std::string extension = file.path().extension().string();
      if (extension != ".h" && extension != ".cpp") continue;
      const std::string name = fs::relative(file.path(), source_dir).generic_string();
      ASSERT_LT(rank(name), order.size()) << name << " stands in no folder of the design";
      std::ifstream in(file.path());
      for (std::string line; std::getline(in, line);) {
        EXPECT_TRUE(extension != ".h" || line.find("nlohmann/json.hpp") == line.npos) << name;
        if (!line.starts_with("#include \"")) continue;
        const std::string path = line.substr(10, line.rfind('"') - 10);
        EXPECT_FALSE(path.starts_with("tests/")) << name << " includes " << path;
        if (rank(path) == order.size()) continue;  // a generated or third-party header
        ++includes;
        EXPECT_TRUE(!name.starts_with("report/") || path.starts_with("report/") ||
                    path.starts_with("cases/io/"))
            << name << " includes " << path;
        EXPECT_LE(rank(path), rank(name)) << name << " includes " << path;
      }
    }
  EXPECT_GT(includes, 500);
}

}  // namespace
}  // namespace desmo::layering_test
