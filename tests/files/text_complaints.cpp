// Files that cannot be read, or whose text is not JSON, are refused at their place.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/files/common.h"
#include "tests/started.h"

namespace desmo::text_complaints_test {
namespace {

namespace fs = std::filesystem;

TEST(MechanismFile, TextThatIsNotJsonIsRefusedAtItsPlace) {
  expect_start(mechanism_complaint(""), "m.json: top level: the text is empty; ");
  expect_start(mechanism_complaint(" \n "), "m.json: top level: the text is empty; ");
  expect_start(mechanism_complaint("[]"), "m.json: top level: is a list; give an object");
  expect_start(mechanism_complaint("{\n  \"a\": 1,\n  }"), "m.json: line 3, column 3: ");
  expect_start(mechanism_complaint("{\"ä\": ]"), "m.json: line 1, column 7: ");
  EXPECT_CONTAINS(mechanism_complaint(slider_crank.substr(0, 300)), "truncated");
  EXPECT_CONTAINS(mechanism_complaint("{} {}"), "line 1, column 4");
  for (const char* number : {"NaN", "nan", "Infinity", "-Infinity", "-NaN", "inf"})
    EXPECT_CONTAINS(mechanism_complaint(std::string("{\"a\": [1, ") + number + "]}"),
                    "NaN and Inf");
  for (const char* number : {"1e999", "-1e999", "1e101", "-2e200"})
    EXPECT_CONTAINS(
        mechanism_complaint(replaced(slider_crank, "[50, 0]", "[50, " + std::string(number) + "]")),
        "the number is too large; ");
  EXPECT_CONTAINS(mechanism_complaint("{\"a\": \"\xff\xfe\"}"), "not UTF-8");
  EXPECT_CONTAINS(mechanism_complaint("{} # note"), "line 1, column 4: is no comment; begin one ");
}

TEST(MechanismFile, KeysGivenTwiceAreRefused) {
  expect_start(mechanism_complaint(replaced(slider_crank, "\"C\": [200, 0]", "\"A\": [200, 0]")),
               "m.json: /points/A: the key is given twice in one object; ");
  expect_start(mechanism_complaint(R"({"a/b": {"~": 1, "~": 2}})"), "m.json: /a~1b/~0: the key is");
}

TEST(MechanismFile, NestingHasALimit) {
  expect_start(mechanism_complaint(std::string(1'000'000, '[')), "m.json: /0/0/0/0/0/0/0/0");
  std::string objects;
  for (int i = 0; i < 100'000; ++i) objects += "{\"a\":";
  const std::string message = mechanism_complaint(objects);
  EXPECT_CONTAINS(message, "nested more than 32 levels deep; ");
  const std::string most = std::string(32, '[') + std::string(32, ']');
  expect_start(mechanism_complaint(most), "m.json: top level: is a list");
}

TEST(MechanismFile, MessagesShowNothingRawAndNothingLong) {
  const std::string message =
      mechanism_complaint("{\"format\": \"\\u001b[31m" + std::string(100'000, 'x') + "\"}");
  EXPECT_EQ(message.find('\x1b'), std::string::npos);
  EXPECT_LT(message.size(), 300u);
  EXPECT_LT(mechanism_complaint("{\"" + std::string(100'000, 'x') + "\": 1, \"a\": {]").size(),
            300u);
  EXPECT_LT(mechanism_complaint("{\"a\": \"" + std::string(100'000, 'x') + "\t\"}").size(), 400u);
  EXPECT_LT(mechanism_complaint("{\"a\": 1" + std::string(100'000, '0') + "}").size(), 300u);
}

TEST(Files, EndWhereTheirTextEnds) {
  for (const std::string& rest : {std::string(1, '\0'), "\n" + std::string(1, '\0') + "{]"}) {
    const std::string place = rest.size() == 1 ? "line 26, column 2: " : "line 27, column 1: ";
    EXPECT_EQ(mechanism_complaint(slider_crank + rest),
              "m.json: " + place + "a byte of value 0 is no text; leave it out");
  }
}

using FileInFolder = InFolder;

TEST_F(FileInFolder, ThatCannotBeReadSaysWhy) {
  const auto complaint_of = [](const fs::path& file) {
    return refusal<InputError>([&] { read_mechanism(file); });
  };
  const std::string missing = file("missing.json");
  EXPECT_EQ(complaint_of(missing), missing + ": there is no such file; check its name and folder");
  EXPECT_EQ(complaint_of(folder_), folder_.string() + ": is a directory; give a file in it");
  EXPECT_CONTAINS(complaint_of("/dev/zero"), "is not a regular file; ");
  const std::string large = write("large.json", "");
  fs::resize_file(large, (std::uintmax_t{64} << 20) + 1);
  EXPECT_CONTAINS(complaint_of(large), "the file is larger than 64 MiB; ");
}

}  // namespace
}  // namespace desmo::text_complaints_test
