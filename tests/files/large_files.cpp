// Files of many bodies are read quickly, and to their end.

#include <gtest/gtest.h>

#include <ctime>

#include "cases/library/library.h"
#include "cases/mechanism/mechanism.h"
#include "tests/files/common.h"

namespace desmo::large_files_test {
namespace {

TEST(Mechanism, OfManyBodiesIsCheckedAndReadQuickly) {
  const std::clock_t start = std::clock();  // in this process: a busy machine does not decide
  const Scene s = parse_scene(scene_of(R"({"generator": "four_bar", "dyads": 5000})",
                                       R"("request": [{"points": ["*"]}, {"everything": true}])"),
                              "", "");
  validate(s.mechanism);
  EXPECT_GT(s.mechanism.bodies.size(), 10'000u);
  // A pendulum chain; every body is joined to the one before.
  std::string points = "\"P0\": [0, 0]", bodies, joints;
  for (int i = 1; i <= 10'000; ++i) {
    const std::string n = std::to_string(i), previous = std::to_string(i - 1);
    points += ", \"P" + n + "\": [" + n + ", 0]";
    bodies += (i == 1 ? "\"b" : ", \"b") + n + "\": {\"points\": [\"P" + previous + "\", \"P" + n +
              "\"]}";
    joints += std::string(i == 1 ? "" : ", ") + R"({"type": "revolute", "bodies": [")" +
              (i == 1 ? "ground" : "b" + previous) + "\", \"b" + n + R"("], "points": ["P)" +
              previous + "\"]}";
  }
  const std::string chain =
      R"({"format": "desmo-mechanism", "version": 1, "name": "chain", "dimension": 2, "points": {)" +
      points + R"(}, "ground": {"points": ["P0"]}, "bodies": {)" + bodies + "}, \"joints\": [" +
      joints + "]}";
  EXPECT_EQ(parse_mechanism(chain, "chain.json").bodies.size(), 10'001u);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  EXPECT_LT(seconds, 10);  // generous, for sanitizers; quadratic work would take longer
}

TEST(Files, EndWhereTheirTextEnds) {
  for (const std::string& rest : {std::string(1, '\0'), "\n" + std::string(1, '\0') + "{]"}) {
    try {
      parse_mechanism(slider_crank + rest, "zero.json");
      ADD_FAILURE() << rest.size();
    } catch (const InputError& error) {
      const std::string place =
          rest.size() == 1 ? "zero.json: line 26, column 2: " : "zero.json: line 27, column 1: ";
      EXPECT_EQ(error.what(), place + "a byte of value 0 is no text; leave it out");
    }
  }
}

}  // namespace
}  // namespace desmo::large_files_test
