// The generator: types of parts, and the files it writes.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "formulations/model/part_type.h"
#include "tests/mechanisms.h"

namespace desmo::generate::generator_test {
namespace {

TEST(PartTypes, AreEqualForTwinsAndDifferOtherwise) {
  const Model m = truck_model(2);
  const auto fingerprint = [&](const char* name) {
    for (const PartDefinition& part : make_partition(m, Partition::group))
      if (m.groups[part.groups.front()].name == name) return describe_type(m, part).fingerprint;
    return std::string("none");
  };
  EXPECT_EQ(fingerprint("axle1/SG-II"), fingerprint("axle2/SG-III"));
  EXPECT_EQ(fingerprint("axle1/SG-IV"), fingerprint("axle2/SG-V"));
  EXPECT_NE(fingerprint("axle1/SG-II"), fingerprint("axle1/SG-IV"));
  EXPECT_EQ(fingerprint("axle1/SG-II").find("axle"), std::string::npos);  // never by name
}

std::string read(const std::string& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Generate, WritesTheSameBytesEveryTime) {
  using Files = std::map<std::string, std::string>;
  const auto generate = [](const std::string& name) {
    const std::filesystem::path folder = testing::TempDir() + name;
    std::filesystem::create_directory(folder);
    EXPECT_EQ(std::system((DESMO_GENERATE " " + folder.string()).c_str()), 0);
    Files files;
    for (const auto& file : std::filesystem::directory_iterator(folder))
      files[file.path().filename()] = read(file.path());
    return files;
  };
  Files a = generate("kernels_a");
  EXPECT_EQ(a, generate("kernels_b"));
  ASSERT_EQ(a.size(), 8u);
  EXPECT_NE(a["cases_kernels.cpp"].find("const double q_WL_x = q[in["), std::string::npos)
      << "names are readable";
  EXPECT_NE(a["cases_explicit_kernels.cpp"].find("// C.x, C.y: two circles\n"), std::string::npos);
  EXPECT_NE(a["library_lane_kernels.cpp"].find("library_lane_kernels("), std::string::npos);
}

TEST(Generate, FailsWhereItCannotWrite) {
  EXPECT_NE(std::system(DESMO_GENERATE " /nonexistent 2>/dev/null"), 0);
  EXPECT_NE(std::system(DESMO_GENERATE " 2>/dev/null"), 0);
}

}  // namespace
}  // namespace desmo::generate::generator_test
