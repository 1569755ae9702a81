// Refusals of scene files, each with the file, the place, the fault and a remedy.

#include <gtest/gtest.h>

#include "tests/files/common.h"

namespace desmo::scene_complaints_test {
namespace {

TEST(SceneFile, WhatIsWrongIsNamedWithItsPlaceAndRemedy) {
  const std::string good = scene_of(slider_crank, driven);
  ASSERT_EQ(scene_complaint(good), "accepted");
  const std::string coefficients = R"("type": "polynomial", "coefficients": [0, 360])";
  const Change changes[] = {
      {"[50, 0]", "[50]", "/mechanism/points/B: wrong dimension: "},
      {"desmo-scene", "desmo-mechanism", "/format: the format is 'desmo-mechanism', not"},
      {"\"version\": 2", "\"version\": 3",
       "/version: this version of the format is not known; versions 1 and 2 are"},
      {"\"version\": 2", "\"version\": 1.5", "/version: this version of the format is not known"},
      {"\"motion\"", "\"motions\"", "/motions: unknown key 'motions'; did you mean 'motion'?"},
      {driven, time_of_one_second, "top level: the driven coordinate 'theta' has no motion; "},
      {"{\"theta\": {\"type", "{\"s\": {\"type", "/motion/s: the coordinate 's' is not driven; "},
      {"{\"theta\": {\"type", "{\"theta2\": {\"type",
       "/motion/theta2: unknown driven coordinate 'theta2'; did you mean 'theta'?"},
      {", " + time_of_one_second, "", "top level: the key 'time' is missing; add it"},
      {"\"step\": 0.01", "\"step\": 0", "/time/step: the step is not above 0; "},
      {"\"step\": 0.01", "\"step\": -1", "/time/step: the step is not above 0; "},
      {"\"step\": 0.01", "\"step\": 1e-10", "/time/step: gives more than 1e9 instants; "},
      {"\"step\": 0.01", "\"step\": 0.3",
       "/time/step: from start to end are 3.33333333333 steps, "},
      {"\"step\": 0.01", "\"step\": 10", "/time/step: from start to end are 0.1 steps, no whole "},
      {"\"end\": 1", "\"end\": 0", "/time/end: the end is not after the start; "},
      {"\"end\": 1", "\"start\": 1e20, \"end\": 2e20", "/time/step: gives more than 1e9 instants"},
      {"\"polynomial\"", "\"spline\"", "/motion/theta/type: unknown type of motion 'spline'; "},
      {"[0, 360]", "[]", "/motion/theta/coefficients: has 0 coefficients; "},
      {"\"coefficients\"", "\"values\"", "/motion/theta/values: unknown key 'values'; "},
      {coefficients, R"("type": "harmonic", "terms": [])", "/motion/theta/terms: has no terms; "},
      {coefficients, R"("type": "harmonic", "terms": [{"frequency": 1}])",
       "/motion/theta/terms/0: the key 'amplitude' is missing; add it"},
      {coefficients, R"("type": "table", "times": [0], "values": [1])",
       "/motion/theta/times: has 1 numbers; a table needs 2 or more"},
      {coefficients, R"("type": "table", "times": [0, 1], "values": [1, 2, 3])",
       "/motion/theta/values: has 3 numbers, and 'times' 2; give as many"},
      {coefficients, R"("type": "table", "times": [0, 1], "values": [1, 2], "ends": "free")",
       "/motion/theta/ends: unknown ends 'free'; there are 'natural', 'clamped', 'periodic'"},
      {coefficients,
       R"("type": "table", "times": [0, 0.5, 1], "values": [1, 2, 3], "ends": "periodic")",
       "/motion/theta: a table that is periodic must end with the value it begins with; change"},
      {coefficients, R"("type": "table", "times": [0, 0.5], "values": [1, 2])",
       "/time: the table of 'theta' reaches only from 0 s to 0.5 s; "},
      {coefficients, R"("type": "table", "times": [0, 1], "values": [1, 2])", "accepted"},
  };
  for (const auto& [old, by, message] : changes)
    expect_start(scene_complaint(replaced(good, old, by)),
                 message == "accepted" ? message : "s.json: " + message);
}

TEST(SceneFile, MembersThatAreWrongAreNamed) {
  const struct {
    const char *member, *message;
  } members[] = {
      {R"("tolerance": 0)", "/tolerance: the tolerance is not above 0; "},
      {R"("tolerance": "small")", "/tolerance: is a text; give a number"},
      {R"("formulation": "group symbolic")", "/formulation: 'group symbolic' is no formulation; "},
      {R"("name": "a\nb")", "/name: 'a\\u000ab' has control characters; "},
      {R"("name": "")", "/name: is empty; "},
      {R"("units": {"length": "1"})", "/units/length: the mechanism has lengths in metres; "},
      {R"("request": [])", "/request: asks for nothing; "},
      {R"("request": [{}])", "/request/0: asks for nothing; "},
      {R"("request": [{"level": "velocity"}])", "/request/0: asks for nothing; "},
      {R"("request": [{"points": []}])", "/request/0/points: is an empty list; "},
      {R"("request": [{"points": ["C1"]}])",
       "/request/0/points/0: unknown point 'C1'; did you mean 'C'?"},
      {R"("request": [{"points": ["Q*"]}])",
       "/request/0/points/0: the pattern 'Q*' matches none of the points; "},
      {R"("request": [{"angles": ["s"]}])",
       "/request/0/angles/0: 's' is none of the angles; ask for it under \"distances\""},
      {R"("request": [{"angles": ["phi"]}])", "/request/0/angles/0: unknown angle 'phi'; "},
      {R"("request": [{"bodies": ["cranc"]}])",
       "/request/0/bodies/0: unknown body 'cranc'; did you mean 'crank'?"},
      {R"("request": [{"points": ["C"], "level": "jerk"}])",
       "/request/0/level: unknown level 'jerk'; there are"},
      {R"("request": [{"everything": false}])", "/request/0/everything: is false; "},
      {R"("request": [{"angles": ["theta", {"mu": {"angle": ["B", "C"]}}]}])",
       "/request/0/angles/1: defines something in a list of names; give"},
      {R"("request": [{"angles": {}}])", "/request/0/angles: defines nothing; "},
      {R"("request": [{"vectors": {"w": [1, 0]}}])",
       "/request/0/vectors: is an object; give a list"},
      {R"("request": [{"angles": {"s": {"angle": ["B", "C"]}}}])",
       "/request/0/angles/s: the name 's' is taken by another point, vector or coordinate; "},
      {R"("request": [{"angles": {"m": {"angle": ["B", "D"]}}}])",
       "/request/0/angles/m/angle/1: unknown point 'D'; "},
      {R"("request": [{"angles": {"m": {"angle": ["B", "C"], "from": ["C", "B"]}}}])",
       "/request/0/angles/m: coordinate 'm': is an angle between a direction and itself"},
      {R"("request": [{"distances": {"m": {"angle": ["B", "C"]}}}])",
       "/request/0/distances/m: is an angle; define it under"},
      {R"("request": [{"points": {"m": {"body": "cranc", "at": [0, 0]}}}])",
       "/request/0/points/m/body: unknown body 'cranc'; did you mean 'crank'?"},
      {R"("request": [{"points": {"m": {"body": "crank", "at": [0]}}}])",
       "/request/0/points/m/at: wrong dimension"},
      {R"("request": [{"points": {"m": {"body": "rod", "at": [90, 0]}}}])",
       "/request/0/points/m: body 'rod': has a length but 3 points; "},
      {R"("request": [{"points": {"m": {"body": "ground", "at": [0, 0]},
                                  "n": {"body": "rod", "at": [90, 0]}}}])",
       "/request/0/points/n: body 'rod': has a length but 3 points; "},
      {R"("request": [{"rotations": ["ground"]}])",
       "/request/0/rotations/0: the ground never turns; name a body that moves"},
      {R"("request": [{"joints": ["J2"]}])",
       "/request/0/joints/0: unknown joint that turns or slides 'J2'; did you mean 'J1'?"},
      {R"("request": [{"ratios": {}}])", "/request/0/ratios: defines nothing; "},
      {R"("request": [{"ratios": {"r": ["s", "C.z"]}}])",
       "/request/0/ratios/r/1: unknown coordinate 'C.z'; give one, or a component"},
      {R"("request": [{"ratios": {"r": ["s"]}}])", "/request/0/ratios/r: has 1 names; give two"},
      {R"("request": [{"ratios": {"r": ["s", "theta"]}}, {"ratios": {"r": ["s", "C.x"]}}])",
       "/request/1/ratios/r: the name is that of another ratio; "},
      {R"("request": [{"ratios": {"r": ["s", "theta"]}, "level": "acceleration"}])",
       "/request/0/level: a ratio is one of velocities; "},
      {R"("request": [{"everything": true, "points": ["A"]}])",
       "/request/0: asks for everything and more; "},
  };
  for (const auto& [member, message] : members)
    expect_start(scene_complaint(scene_of(slider_crank, driven + ", " + member)),
                 std::string("s.json: ") + message);
  const auto named = [](std::size_t characters) {
    return scene_of(slider_crank, driven + ", \"name\": \"" + std::string(characters, 'a') + '"');
  };
  EXPECT_EQ(scene_complaint(named(200)), "accepted");
  EXPECT_CONTAINS(scene_complaint(named(201)), "is longer than 200 characters; shorten it");
  expect_start(
      scene_complaint(
          scene_of(spatial, driven + R"(, "request": [{"joints": ["spherical/crank/rod"]}])")),
      "s.json: /request/0/joints/0: 'spherical/crank/rod' is a joint of type 'spherical', which "
      "neither turns about one axis nor slides along one; ask for rotations or points of its bod");
  const std::string free = replaced(slider_crank, "\"mm\"", "\"1\"");
  EXPECT_EQ(scene_complaint(scene_of(free, driven)), "accepted");
  expect_start(scene_complaint(scene_of(free, driven + R"(, "units": {"length": "mm"})")),
               "s.json: /units/length: the mechanism's unit of length is '1', any one unit; ");
}

/// A message about a value that is no object has an example of one.
TEST(SceneFile, ShapesThatAreWrongAreShownRight) {
  const std::string good = scene_of(slider_crank, driven + R"(, "request": [{"points": ["C"]}])");
  const Change changes[] = {
      {R"({"length": "mm", "angle": "deg"})", "\"mm\"",
       "/mechanism/units: is a text; give an object such as {\"length\": \"mm\", \"angle\": "
       "\"deg\"}"},
      {R"({"points": ["A", "B"]})", R"(["A", "B"])",
       "/mechanism/bodies/crank: is a list; give an object such as {\"points\": [\"A\", \"B\"]}"},
      {R"({"angle": ["A", "B"], "estimate": 10})", R"(["A", "B"])",
       "/mechanism/coordinates/theta: is a list; give an object such as {\"angle\": "},
      {R"({"type": "polynomial", "coefficients": [0, 360]})", "360",
       "/motion/theta: is a number; give an object such as {\"type\": \"speed\", \"value\": 360}"},
      {R"({"end": 1, "step": 0.01})", "[0, 1]",
       "/time: is a list; give an object such as {\"end\": 1, \"step\": 0.01}"},
      {R"([{"points": ["C"]}])", R"(["C"])",
       "/request/0: is a text; give an object such as {\"points\": [\"C\"]}"},
      {R"({"points": ["C"]}])", R"({"ratios": ["s", "theta"]}])",
       "/request/0/ratios: is a list; give an object such as {\"i\": [\"s\", \"C.x\"]}"},
      {R"("format": "desmo-mechanism",)", "",
       "/mechanism: the key 'format' is missing; add it: \"format\": \"desmo-mechanism\""},
  };
  for (const auto& [old, by, message] : changes)
    expect_start(scene_complaint(replaced(good, old, by)), "s.json: " + message);
}

TEST(SceneFile, MechanismsThatDoNotExistAreNamed) {
  const struct {
    const char *mechanism, *message;
  } mechanisms[] = {
      {R"({"library": "slider_crnak"})",
       "/mechanism/library: unknown library mechanism 'slider_crnak'; did you mean "
       "'slider_crank'?"},
      {R"({"library": "slider_crank", "axles": 2})", "/mechanism/axles: unknown key 'axles'; "},
      {R"({"generator": "five_bar", "dyads": 2})",
       "/mechanism/generator: unknown generator 'five_bar'; did you mean 'four_bar'?"},
      {R"({"generator": "four_bar"})", "/mechanism: the key 'dyads' is missing; add it"},
      {R"({"generator": "four_bar", "axles": 2})", "/mechanism/axles: unknown key 'axles'; "},
      {R"({"generator": "four_bar", "dyads": 2.5})", "/mechanism/dyads: must be a whole number"},
      {R"({"generator": "four_bar", "dyads": 0})", "/mechanism/dyads: must be a whole number"},
      {R"({"generator": "four_bar", "dyads": 10000000})",
       "/mechanism/dyads: must be a whole number from 1 to 100000; "},
      {"7", "/mechanism: is no mechanism; "},
      {"{}", "/mechanism: the key 'format' is missing; add it"},
      {R"("")", "/mechanism: '' is no file name; "},
      {R"("/dev/zero")", "/mechanism: the mechanism file '/dev/zero': is not a regular file; "},
  };
  for (const auto& [mechanism, message] : mechanisms)
    expect_start(scene_complaint(scene_of(mechanism, "")), std::string("s.json: ") + message);
}

}  // namespace
}  // namespace desmo::scene_complaints_test
