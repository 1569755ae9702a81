// The program of drawn scenes: flags of GoogleTest, and how many scenes are drawn.
#include <gtest/gtest.h>

#include <cstdio>
#include <exception>
#include <string>
#include <string_view>

#include "formulations/algebra/blas.h"
#include "tests/properties/options.h"

namespace desmo::properties {

Options& options() {
  static Options all;
  return all;
}

namespace {

constexpr const char* usage =
    "properties_test: is every number of drawn scenes within its radius, or flagged?\n"
    "  --scenes N            draw that many (20)\n"
    "  --seed S              draw others (1)\n"
    "  --ids N               formulations for each scene (6); 0: all\n"
    "  --scene N             this scene alone\n"
    "  --formulation ID      in this formulation alone\n"
    "  --write-failures DIR  write scenes with findings to files there\n";

void read(const std::string& flag, const std::string& value) {
  Options& o = options();
  if (flag == "--scenes")
    o.scenes = std::stoi(value);
  else if (flag == "--seed")
    o.seed = std::stoull(value);
  else if (flag == "--ids")
    o.ids = std::stoi(value);
  else if (flag == "--scene")
    o.scene = std::stoi(value);
  else if (flag == "--formulation")
    o.id = value;
  else if (flag == "--write-failures")
    o.failures = value;
  else
    throw std::invalid_argument("unknown flag");
}

}  // namespace
}  // namespace desmo::properties

int main(int count, char** arguments) {
  testing::InitGoogleTest(&count, arguments);
  desmo::set_blas_threads(1);
  for (int i = 1; i < count; i += 2) try {
      if (i + 1 == count) throw std::invalid_argument("no value");
      desmo::properties::read(arguments[i], arguments[i + 1]);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s: %s\n%s", arguments[i], error.what(), desmo::properties::usage);
      return 64;
    }
  return RUN_ALL_TESTS();
}
