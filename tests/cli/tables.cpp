// What desmo solve says of couplings by tables.

#include <string>

#include "tests/cli/program.h"

namespace desmo::tables_test {
namespace {

/// A crank a and a wheel w that follows it by tables [°].
std::string wheel(const std::string& couplings, const std::string& driver,
                  const std::string& motion, const std::string& step) {
  return R"({"format": "desmo-scene", "version": 2, "mechanism": {
    "format": "desmo-mechanism", "version": 1, "name": "wheel", "dimension": 2,
    "units": {"angle": "deg"},
    "points": {"O": [0, 0], "A": [1, 0], "W": [3, 0], "B": [4, 0]},
    "ground": {"points": ["O", "W"]},
    "bodies": {"crank": {"points": ["O", "A"]}, "wheel": {"points": ["W", "B"]}},
    "joints": [{"type": "revolute", "bodies": ["ground", "crank"], "points": ["O"]},
               {"type": "revolute", "bodies": ["ground", "wheel"], "points": ["W"]}],
    "coordinates": {"a": {"angle": ["O", "A"]}, "w": {"angle": ["W", "B"]}},
    "couplings": {)" +
         couplings + R"(}, "drivers": [")" + driver + R"("]}, "motion": {")" + driver +
         R"(": {"type": "polynomial", "coefficients": [)" + motion +
         R"(]}}, "time": {"end": 1, "step": )" + step + "}}";
}

/// Both tables agree at each 20°, and where the wheel is drawn; they part by 3° at 130°.
TEST_F(Cli, TellsContradictionsBetweenRows) {
  std::string at, more_at, values, more;
  for (int a = -40; a <= 200; a += 10) {
    const std::string number = std::to_string(a), comma = a > -40 ? ", " : "";
    if (a % 20 == 0) at += comma + number;
    more_at += comma + number;
    more += comma + std::to_string(a == 130 ? a + 3 : a);
  }
  const auto table = [](const std::string& name, const std::string& x, const std::string& y) {
    return '"' + name + R"(": {"coordinate": "w", "of": "a", "at": [)" + x + R"(], "values": [)" +
           y + "]}";
  };
  write("scene.json", wheel(table("first", at, at) + ", " + table("second", more_at, more), "a",
                            "0, 160", "0.125"));
  ASSERT_EQ(desmo("solve scene.json"), 0) << err_;
  EXPECT_TRUE(says(" s, between rows: the equations contradict each other: 'second: coupling'"))
      << err_;
  EXPECT_EQ(desmo("solve scene.json --strict"), 1);
}

TEST_F(Cli, TellsThatAMotionLocksAtTheExtremumOfATable) {
  write("scene.json", wheel(R"("cam": {"coordinate": "w", "of": "a", "at": [-20, 0, 20, 40, 60, 80],
                 "values": [-5, 0, 15, 20, 15, 0]})",
                            "w", "0, 50", "0.1"));
  EXPECT_EQ(desmo("solve scene.json"), 1);
  EXPECT_FALSE(says("outside")) << err_;
  EXPECT_FALSE(says("nan")) << err_;
}

/// A step of 80,000 turns.
TEST_F(Cli, TellsThatTestsEnded) {
  write("scene.json",
        wheel(R"("cam": {"coordinate": "w", "of": "a", "at": [-20, 0, 100, 200, 300, 330],
                 "values": [0, 0, 15, 20, 15, 0], "ends": "periodic"})",
              "a", "0, 3e7", "0.5"));
  EXPECT_EQ(desmo("solve scene.json --strict"), 1);
  EXPECT_TRUE(says("the budget of tests of a step ended before the motion was followed")) << err_;
  EXPECT_TRUE(says("take smaller steps, or solve without --strict")) << err_;
  EXPECT_FALSE(says("singular")) << err_;
}

}  // namespace
}  // namespace desmo::tables_test
