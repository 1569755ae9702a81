// The generator: types of parts, and the files it writes.

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>

#include "formulations/model/part_type.h"
#include "tests/mechanisms.h"
#include "tests/started.h"

namespace desmo::generate::generator_test {
namespace {

TEST(PartTypes, AreEqualForTwinsAndDifferOtherwise) {
  const Model m = truck_model(2);
  const auto fingerprint = [&](const char* name) {
    for (const PartDefinition& part : make_partition(m, Partition::group))
      if (m.groups[part.groups.front()].name == name) return describe_type(m, part).fingerprint;
    throw std::invalid_argument(name);
  };
  EXPECT_EQ(fingerprint("axle1/SG-I"), fingerprint("axle2/SG-I"));
  EXPECT_EQ(fingerprint("axle1/SG-II"), fingerprint("axle2/SG-III"));
  EXPECT_EQ(fingerprint("axle1/SG-IV"), fingerprint("axle2/SG-V"));
  EXPECT_NE(fingerprint("axle1/SG-I"), fingerprint("axle1/SG-II"));
  EXPECT_NE(fingerprint("axle1/SG-II"), fingerprint("axle1/SG-IV"));
  EXPECT_EQ(fingerprint("axle1/SG-II").find("axle"), std::string::npos);  // never by name
}

using Generate = InFolder;

/// The generator writes again what was compiled.
TEST_F(Generate, WritesTheSameBytesEveryTime) {
  const std::filesystem::path compiled = std::filesystem::path(DESMO_GENERATE).parent_path(),
                              folder = folder_ / "kernels";
  std::filesystem::create_directory(folder);
  EXPECT_EQ(shell(DESMO_GENERATE " " + folder.string() + " natural"), 0) << err_;
  std::map<std::string, std::string> files;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    const std::string name = file.path().filename();
    files[name] = text_of(file.path());
    EXPECT_TRUE(files[name] == text_of(compiled / name)) << name;
  }
  ASSERT_EQ(files.size(), 6u);
  EXPECT_NE(files["cases_kernels.cpp"].find("const double q_WL_x = q[in["), std::string::npos)
      << "names are readable";
}

TEST_F(Generate, FailsWhereItCannotWrite) {
  for (const char* arguments : {"/nonexistent natural", "/tmp", "/tmp all", ""})
    EXPECT_NE(shell(std::string(DESMO_GENERATE " ") + arguments), 0) << arguments;
}

}  // namespace
}  // namespace desmo::generate::generator_test
