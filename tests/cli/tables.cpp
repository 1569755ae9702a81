// Notes of desmo solve on couplings by tables.

#include <vector>

#include "tests/cli/program.h"
#include "tests/wheel.h"

namespace desmo::tables_test {
namespace {

/// Both tables agree at each 20°, and where the wheel is drawn; they part by 3° at 130°.
TEST_F(Cli, TellsContradictionsBetweenRows) {
  std::vector<double> at, more_at, more;
  for (int a = -40; a <= 200; a += 10) {
    if (a % 20 == 0) at.push_back(a);
    more_at.push_back(a);
    more.push_back(a == 130 ? a + 3 : a);
  }
  write("scene.json", Wheel{.couplings = coupling_table("first", at, at) + ", " +
                                         coupling_table("second", more_at, more),
                            .speed = 160,
                            .step = 0.125}
                          .text());
  expect_said(0, "solve scene.json",
              " s, between rows: the equations contradict each other: 'second: coupling'",
              " deg; the motion is", "largest contradiction: 'second: coupling' is off by ",
              "e+00 deg\n");
  expect_said(0, "solve scene.json --units si", " rad; the motion is", "e-02 rad\n");
  EXPECT_EQ(desmo("solve scene.json --strict"), 1);
}

/// A step of 80,000 turns.
TEST_F(Cli, TellsThatTestsEnded) {
  const std::vector<double> at{-20, 0, 100, 200, 300, 330}, lift{0, 0, 15, 20, 15, 0};
  write("scene.json",
        Wheel{.couplings = coupling_table("cam", at, lift, "periodic"), .speed = 3e7, .step = 0.5}
            .text());
  expect_said(1, "solve scene.json --strict",
              "the budget of tests of a step ended before the motion was followed",
              "take smaller steps, or solve without --strict");
  EXPECT_FALSE(says("singular")) << err_;
}

}  // namespace
}  // namespace desmo::tables_test
