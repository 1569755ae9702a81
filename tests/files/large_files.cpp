// Files of many bodies are read quickly.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "cases/mechanism/mechanism.h"
#include "tests/files/common.h"

namespace desmo::large_files_test {
namespace {

/// Returns the text of a pendulum chain; every body is joined to the one before.
std::string pendulum_chain(int links) {
  std::string points = "\"P0\": [0, 0]", bodies, joints;
  for (int i = 1; i <= links; ++i) {
    const std::string n = std::to_string(i), previous = std::to_string(i - 1);
    points += ", \"P" + n + "\": [" + n + ", 0]";
    bodies += (i == 1 ? "\"b" : ", \"b") + n + "\": {\"points\": [\"P" + previous + "\", \"P" + n +
              "\"]}";
    joints += std::string(i == 1 ? "" : ", ") + R"({"type": "revolute", "bodies": [")" +
              (i == 1 ? "ground" : "b" + previous) + "\", \"b" + n + R"("], "points": ["P)" +
              previous + "\"]}";
  }
  return R"({"format": "desmo-mechanism", "version": 1, "name": "chain", "dimension": 2, "points": {)" +
         points + R"(}, "ground": {"points": ["P0"]}, "bodies": {)" + bodies + "}, \"joints\": [" +
         joints + "]}";
}

/// Returns the least seconds of this process that something takes, of three times.
template <class Work>
double least_seconds(Work work) {
  double least = INFINITY;
  for (int i = 0; i < 3; ++i) {
    const std::clock_t start = std::clock();
    work();
    least = std::min(least, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return least;
}

/// Four times as many bodies take some four times as long; quadratic work would take sixteen.
TEST(Mechanism, OfManyBodiesIsCheckedAndReadInProportion) {
  constexpr int few = 2'000, times_as_many = 4, max_ratio = 10;
  const auto dyads = [](int count) {
    const Scene s =
        parse_scene(scene_of(R"({"generator": "four_bar", "dyads": )" + std::to_string(count) + "}",
                             R"("request": [{"points": ["*"]}, {"everything": true}])"),
                    "", "");
    validate(s.mechanism);
    EXPECT_GT(s.mechanism.bodies.size(), 2u * count);
  };
  EXPECT_LT(least_seconds([&] { dyads(times_as_many * few); }),
            max_ratio * least_seconds([&] { dyads(few); }));
  const auto links = [](const std::string& chain, std::size_t count) {
    EXPECT_EQ(parse_mechanism(chain, "chain.json").bodies.size(), count + 1);
  };
  const std::string short_chain = pendulum_chain(few),
                    long_chain = pendulum_chain(times_as_many * few);
  EXPECT_LT(least_seconds([&] { links(long_chain, times_as_many * few); }),
            max_ratio * least_seconds([&] { links(short_chain, few); }));
}

}  // namespace
}  // namespace desmo::large_files_test
