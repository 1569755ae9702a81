// The program of drawn scenes: flags of GoogleTest, and how many scenes are drawn.
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

#include "formulations/algebra/blas.h"
#include "tests/properties/options.h"

namespace desmo::properties {

Options& options() {
  static Options all;
  return all;
}

namespace {

void declare_options(CLI::App& parser) {
  Options& o = options();
  const CLI::Range number(0, 1'000'000'000);
  parser.add_option("--scenes", o.scenes, "Number of scenes that are drawn")
      ->check(number)
      ->capture_default_str();
  parser.add_option("--seed", o.seed, "Seed of their random numbers")->capture_default_str();
  parser.add_option("--ids", o.ids, "Formulations for each scene; 0: all")
      ->check(number)
      ->capture_default_str();
  parser.add_option("--scene", o.scene, "This scene alone")->check(number);
  parser.add_option("--formulation", o.id, "In this formulation alone");
  parser.add_option("--write-failures", o.failures, "Folder for files of scenes with findings");
}

}  // namespace
}  // namespace desmo::properties

int main(int count, char** arguments) {
  testing::InitGoogleTest(&count, arguments);
  desmo::set_blas_threads(1);
  CLI::App parser(
      "properties_test: is every number of drawn scenes within its radius, or flagged?");
  desmo::properties::declare_options(parser);
  try {
    parser.parse(count, arguments);
  } catch (const CLI::ParseError& error) {
    constexpr int usage_error = 64;
    return parser.exit(error) == 0 ? 0 : usage_error;
  }
  return RUN_ALL_TESTS();
}
