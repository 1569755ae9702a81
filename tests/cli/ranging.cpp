// desmo range.

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/cli/program.h"

namespace desmo::ranging_test {
namespace {

using Json = nlohmann::json;

TEST_F(Cli, SaysHowFarACrankGoesAndWhatStopsIt) {
  write("scene.json", locks);  // lengths in mm
  ASSERT_EQ(desmo("range scene.json"), 0) << err_;
  for (const char* text :
       {"short, from t = 0 s", "theta, from 0 rad", "  up    0.643501108793 rad: locks, to ",
        "  down  -0.643501108793 rad: locks", "group   SG-II (rod, slider)", "moves   C",
        "joints  revolute/rod/slider, prismatic/ground/slider", "loop    crank, rod"})
    EXPECT_TRUE(prints(text)) << text << "\n" << out_;
  ASSERT_EQ(desmo("range - --json <scene.json"), 0) << err_;
  const Json driver = Json::parse(out_)["drivers"][0];
  EXPECT_EQ(driver["name"], "theta");
  EXPECT_EQ(driver["unit"], "rad");
  EXPECT_EQ(driver["idle"], false);
  ASSERT_EQ(driver["ends"].size(), 2u);
  const Json up = driver["ends"][1];
  EXPECT_EQ(up["stop"], "dead_point");
  EXPECT_NEAR(up["value"].get<double>(), std::asin(0.6), 1e-13);
  EXPECT_GT(up["beyond"], up["value"]);
  EXPECT_NEAR(up["beyond"].get<double>(), std::asin(0.6), 1e-12);
  EXPECT_EQ(up["group"], "SG-II");
}

TEST_F(Cli, SaysOfEveryDriverWhereItStops) {
  ASSERT_EQ(desmo("range stewart --json"), 0) << err_;
  const Json drivers = Json::parse(out_)["drivers"];
  ASSERT_EQ(drivers.size(), 6u);
  for (const Json& d : drivers) {
    EXPECT_EQ(d["unit"], "m");
    EXPECT_LT(d["ends"][0]["value"], d["start"]);
    EXPECT_GT(d["ends"][1]["value"], d["start"]);
  }
  ASSERT_EQ(desmo("range slider_crank"), 0) << err_;
  EXPECT_TRUE(prints("up    6.28318530718 rad: turns fully")) << out_;
}

TEST_F(Cli, RangesNeedAStart) {
  std::string scene = locks;
  scene.replace(scene.find("[0, 360]"), 8, "[90, 1]");
  write("scene.json", scene);
  EXPECT_EQ(desmo("range scene.json"), 1);
  EXPECT_TRUE(says("scene.json: no position was found at the start of driver 'theta'")) << err_;
  EXPECT_TRUE(says("SG-II")) << err_;
  EXPECT_TRUE(out_.empty());
  EXPECT_EQ(desmo("range"), 64);
  EXPECT_EQ(desmo("range nothing"), 66);
}

}  // namespace
}  // namespace desmo::ranging_test
