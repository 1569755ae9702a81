// Mechanism and scene files: what is read, and that whatever is wrong with them is refused with a
// message that names file, place and remedy.

#include "cases/files.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <numbers>
#include <random>

#include "cases/cases.h"
#include "cases/library.h"
#include "cases/names.h"

namespace desmo {
namespace {

namespace fs = std::filesystem;

const std::string slider_crank = R"({
  "format": "desmo-mechanism",
  "version": 1,
  "name": "slider_crank",
  "dimension": 2,
  "units": {"length": "mm", "angle": "deg"},
  "points": {"A": [0, 0], "B": [50, 0], "C": [200, 0]},
  "vectors": {"x": [2, 0]},
  "ground": {"points": ["A"], "vectors": ["x"]},
  "bodies": {
    "crank": {"points": ["A", "B"]},
    "rod": {"points": ["B", "C"], "length": 150},
    "slider": {"points": ["C"], "vectors": ["x"]}
  },
  "joints": [
    {"name": "J1", "type": "revolute", "bodies": ["ground", "crank"], "points": ["A"]},
    {"type": "revolute", "bodies": ["crank", "rod"], "points": ["B"]},
    {"type": "revolute", "bodies": ["rod", "slider"], "points": ["C"]},
    {"type": "prismatic", "bodies": ["ground", "slider"], "vectors": ["x"], "points": ["A", "C"]}
  ],
  "coordinates": {
    "theta": {"angle": ["A", "B"], "estimate": 10},
    "s": {"distance": ["A", "C"], "along": "x", "estimate": 201}
  },
  "drivers": ["theta"]
})";

// Two links on ball joints: every direction of space is defined in some way.
const std::string spatial = R"({
  "format": "desmo-mechanism",
  "version": 1,
  "name": "spatial",
  "dimension": 3,
  "points": {"A": [0, 0, 0], "B": [1, 0, 0], "C": [2, 1, 0]},
  "vectors": {
    "w": {"normal": ["v", "u"]},
    "v": {"normal": ["u", ["A", "B"]]},
    "u": [0, 0, 1],
    "r": {"along": ["B", "C"]}
  },
  "ground": {"points": ["A"], "vectors": ["u", "v", "w"]},
  "bodies": {
    "crank": {"points": ["A", "B"], "vectors": ["u"]},
    "rod": {"points": ["B", "C"], "vectors": ["r"]}
  },
  "joints": [
    {"type": "revolute", "bodies": ["ground", "crank"], "points": ["A"], "vectors": ["u"]},
    {"type": "spherical", "bodies": ["crank", "rod"], "points": ["B"]}
  ],
  "coordinates": {
    "theta": {"angle": ["A", "B"], "from": "-w", "towards": "v"},
    "z": {"component": "C", "axis": "z"}
  },
  "drivers": ["theta"]
})";

std::string scene_with(const std::string& members) {
  return "{\"format\": \"desmo-scene\", \"version\": 1, " + members + "}";
}

std::string scene_of(const std::string& mechanism, const std::string& members) {
  return scene_with("\"mechanism\": " + mechanism + (members.empty() ? "" : ", ") + members);
}

const std::string motion =
    R"("motion": {"theta": {"type": "polynomial", "coefficients": [0, 360]}})";
const std::string time_of_one_second = R"("time": {"end": 1, "step": 0.01})";
const std::string driven = motion + ", " + time_of_one_second;

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  const auto at = text.find(old);
  if (at == std::string::npos)
    throw std::logic_error("the test replaces what is not there: " + old);
  return text.replace(at, old.size(), by);
}

template <class Parse>
std::string complaint(Parse parse) {
  try {
    parse();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

std::string mechanism_complaint(const std::string& text) {
  return complaint([&] { parse_mechanism(text, "m.json"); });
}

std::string scene_complaint(const std::string& text) {
  return complaint([&] { parse_scene(text, "s.json", ""); });
}

void expect_start(const std::string& message, const std::string& start) {
  EXPECT_EQ(message.substr(0, start.size()), start) << message;
}

// The message, from the place on, begins as expected when a part of a good file is replaced.
struct Change {
  std::string old, by, message;
};

TEST(MechanismFile, IsReadInSiUnitsAndInItsOrder) {
  const Description d = parse_mechanism(slider_crank, "m.json");
  EXPECT_EQ(d.name, "slider_crank");
  EXPECT_EQ(d.dimension, 2);
  EXPECT_EQ(d.length_unit, "m");
  ASSERT_EQ(d.points.size(), 3u);
  EXPECT_EQ(d.points[2].name, "C");
  EXPECT_DOUBLE_EQ(d.points[2].position[0], 0.2);
  EXPECT_DOUBLE_EQ(d.vectors[0].direction[0], 1);
  ASSERT_EQ(d.bodies.size(), 4u);
  EXPECT_EQ(d.bodies[0].name, "ground");
  EXPECT_EQ(d.bodies[3].name, "slider");
  EXPECT_DOUBLE_EQ(d.bodies[2].length.value(), 0.15);
  EXPECT_EQ(d.bodies[2].points, (std::vector{1, 2}));
  ASSERT_EQ(d.joints.size(), 4u);
  EXPECT_EQ(d.joints[0].name, "J1");
  EXPECT_EQ(d.joints[1].name, "revolute/crank/rod");
  EXPECT_EQ(d.joints[3].type, Description::JointType::prismatic);
  EXPECT_EQ(d.joints[3].bodies, (std::array{0, 3}));
  EXPECT_EQ(d.joints[3].points, (std::vector{0, 2}));
  ASSERT_EQ(d.coordinates.size(), 2u);
  EXPECT_TRUE(d.coordinates[0].driven);
  EXPECT_FALSE(d.coordinates[1].driven);
  EXPECT_NEAR(d.coordinates[0].estimate.value(), std::numbers::pi / 18, 1e-15);
  EXPECT_DOUBLE_EQ(d.coordinates[1].estimate.value(), 0.201);
  EXPECT_EQ(d.coordinates[1].type, Description::CoordinateType::along);
}

TEST(MechanismFile, DirectionsAreDefinedInAnyOrder) {
  const Description d = parse_mechanism(spatial, "m.json");
  const auto expect_direction = [&](int i, double x, double y, double z) {
    EXPECT_NEAR(d.vectors[i].direction[0], x, 1e-15) << i;
    EXPECT_NEAR(d.vectors[i].direction[1], y, 1e-15) << i;
    EXPECT_NEAR(d.vectors[i].direction[2], z, 1e-15) << i;
  };
  expect_direction(0, 1, 0, 0);
  expect_direction(1, 0, 1, 0);
  expect_direction(3, std::sqrt(0.5), std::sqrt(0.5), 0);
  EXPECT_EQ(d.vectors[3].along.value(), (std::array{1, 2}));
  EXPECT_FALSE(d.vectors[0].along);
  EXPECT_TRUE(d.coordinates[0].opposite);
  EXPECT_EQ(d.coordinates[0].from.vector, 0);
  EXPECT_EQ(d.coordinates[0].towards.vector, 1);
  EXPECT_EQ(d.coordinates[1].axis, 2);
}

TEST(MechanismFile, JointsWithoutNamesAreToldApart) {
  const std::string joint = R"({"type": "revolute", "bodies": ["crank", "rod"], "points": ["B"]})";
  const Description d = parse_mechanism(replaced(slider_crank, joint, joint + ", " + joint), "");
  EXPECT_EQ(d.joints[1].name, "revolute/crank/rod");
  EXPECT_EQ(d.joints[2].name, "revolute/crank/rod/2");
}

TEST(MechanismFile, TextThatIsNotJsonIsRefusedAtItsPlace) {
  expect_start(mechanism_complaint(""), "m.json: top level: the text is empty; ");
  expect_start(mechanism_complaint(" \n "), "m.json: top level: the text is empty; ");
  expect_start(mechanism_complaint("[]"), "m.json: top level: is a list; give an object");
  expect_start(mechanism_complaint("{\n  \"a\": 1,\n  }"), "m.json: line 3, column 3: ");
  expect_start(mechanism_complaint("{\"ä\": ]"), "m.json: line 1, column 7: ");
  EXPECT_NE(mechanism_complaint(slider_crank.substr(0, 300)).find("truncated"), std::string::npos);
  EXPECT_NE(mechanism_complaint("{} {}").find("line 1, column 4"), std::string::npos);
  for (const char* number : {"NaN", "nan", "Infinity", "-Infinity", "-NaN", "inf"})
    EXPECT_NE(mechanism_complaint(std::string("{\"a\": [1, ") + number + "]}").find("NaN and Inf"),
              std::string::npos)
        << mechanism_complaint(std::string("{\"a\": [1, ") + number + "]}");
  for (const char* number : {"1e999", "-1e999", "1e101", "-2e200"})
    EXPECT_NE(
        mechanism_complaint(replaced(slider_crank, "[50, 0]", "[50, " + std::string(number) + "]"))
            .find("the number is too large; "),
        std::string::npos);
  EXPECT_NE(mechanism_complaint("{\"a\": \"\xff\xfe\"}").find("not UTF-8"), std::string::npos);
  EXPECT_NE(mechanism_complaint("{} // note").find("no comments"), std::string::npos);
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
  EXPECT_NE(message.find("nested more than 32 levels deep; "), std::string::npos) << message;
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

TEST(MechanismFile, WhatIsWrongIsNamedWithItsPlaceAndRemedy) {
  const Change changes[] = {
      {"desmo-mechanism", "desmo-mechanisms", "/format: the format is 'desmo-mechanisms', not"},
      {"desmo-mechanism", "desmo-scene", "/format: the format is 'desmo-scene', not"},
      {"\"format\": \"desmo-mechanism\",", "", "top level: the key 'format' is missing; add it"},
      {"\"version\": 1", "\"version\": 2", "/version: this version of the format is not known; "},
      {"\"version\": 1", "\"version\": \"1\"", "/version: is a text; give a number"},
      {"\"drivers\"", "\"driver\"", "/driver: unknown key 'driver'; did you mean 'drivers'?"},
      {"\"dimension\": 2,", "", "top level: the key 'dimension' is missing; add it"},
      {"\"dimension\": 2", "\"dimension\": 4", "/dimension: must be a whole number from 2 to 3; "},
      {"\"dimension\": 2", "\"dimension\": 2.5", "/dimension: must be a whole number"},
      {"\"dimension\": 2", "\"dimension\": 3", "/points/A: wrong dimension: has 2 components"},
      {"[50, 0]", "[50, 0, 0]", "/points/B: wrong dimension: has 3 components in a mechanism of"},
      {"[50, 0]", "[50, \"0\"]", "/points/B/1: is a text; give a number"},
      {"[50, 0]", "50", "/points/B: is a number; give a list"},
      {"[50, 0]", "null", "/points/B: is null; give a list"},
      {"\"mm\"", "\"km\"",
       "/units/length: unknown unit 'km'; there are 'm', 'mm', 'cm', 'in', '1'"},
      {"\"deg\"", "true", "/units/angle: is true; give a text"},
      {"\"slider_crank\"", "\"slider crank\"", "/name: 'slider crank' is not a name; use "},
      {"\"C\": [200", "\"-C\": [200", "/points/-C: '-C' is not a name; "},
      {"\"C\": [200", "\"\": [200", "/points/: '' is not a name; "},
      {"\"C\": [200", "\"C*\": [200", "/points/C*: 'C*' is not a name; "},
      {"[2, 0]", "[0, 0]", "/vectors/x: a direction of length 0; "},
      {"[2, 0]", "{\"normal\": [\"x\", \"x\"]}", "/vectors/x/normal: a normal needs three dim"},
      {"[2, 0]", "{\"along\": [\"A\", \"A\"]}", "/vectors/x/along: names the point 'A' twice; "},
      {"[2, 0]", "{}", "/vectors/x: defines a direction by both or neither of normal and along; "},
      {"[2, 0]", "\"y\"", "/vectors/x: is no direction; "},
      {"\"crank\": {\"points\": [\"A\", \"B\"]}", "\"crank\": {\"points\": [\"A\", \"B1\"]}",
       "/bodies/crank/points/1: unknown point 'B1'; did you mean 'B'?"},
      {"\"crank\": {\"points\": [\"A\", \"B\"]}", "\"crank\": {\"points\": [\"A\", \"B\", \"B\"]}",
       "/bodies/crank: body 'crank': lists the point 'B' twice; "},
      {"\"crank\": {", "\"ground\": {", "/bodies/ground: 'ground' is the name of the ground; "},
      {"\"crank\": {", "\"A\": {", "/joints/0/bodies/1: unknown body 'crank'; "},
      {"\"s\": {", "\"A\": {", "/coordinates/A: coordinate 'A': the name is given twice among"},
      {"\"length\": 150", "\"length\": 0", "/bodies/rod: body 'rod': the length is not above 0; "},
      {"\"length\": 150", "\"length\": -1", "/bodies/rod: body 'rod': the length is not above 0; "},
      {"\"C\": [200, 0]", "\"C\": [50, 0]", "/bodies/rod: body 'rod': its points 'B' and 'C' coin"},
      {"{\"points\": [\"C\"], \"vectors\": [\"x\"]}",
       "{\"points\": [\"C\"], \"vectors\": [\"x\"], \"length\": 1}",
       "/bodies/slider: body 'slider': has a length but 1 points; "},
      {"\"ground\": {\"points\": [\"A\"],", "\"ground\": {\"length\": 1, \"points\": [\"A\"],",
       "/ground/length: unknown key 'length'; "},
      {"\"joints\"", "\"units2\"", "/units2: unknown key 'units2'; did you mean 'units'"},
      {"\"type\": \"revolute\", \"bodies\": [\"crank\"",
       "\"type\": \"revolut\", \"bodies\": [\"crank\"",
       "/joints/1/type: unknown type of joint 'revolut'; did you mean 'revolute'?"},
      {"\"type\": \"revolute\", \"bodies\": [\"crank\"", "\"bodies\": [\"crank\"",
       "/joints/1: the key 'type' is missing; add it"},
      {"\"type\": \"revolute\", \"bodies\": [\"crank\"",
       "\"type\": \"spherical\", \"bodies\": [\"crank\"",
       "/joints/1: joint 'spherical/crank/rod': spherical joints exist only in space"},
      {"[\"crank\", \"rod\"]", "[\"crank\"]", "/joints/1/bodies: has 1 names; give two"},
      {"[\"crank\", \"rod\"]", "[\"crank\", \"crank\"]",
       "/joints/1/bodies: names the body 'crank'"},
      {"[\"crank\", \"rod\"], \"points\": [\"B\"]", "[\"crank\", \"rod\"], \"points\": [\"C\"]",
       "/joints/1: joint 'revolute/crank/rod': the point 'C' is not carried by 'crank'; revolute"},
      {"[\"crank\", \"rod\"], \"points\": [\"B\"]", "[\"crank\", \"rod\"]",
       "/joints/1: joint 'revolute/crank/rod': has 0 points and 0 vectors; revolute takes one"},
      {"\"points\": [\"A\", \"C\"]}", "\"points\": [\"A\", \"A\"]}",
       "/joints/3: joint 'prismatic/ground/slider': lists the point 'A' twice; "},
      {"\"points\": [\"A\", \"C\"]}", "\"points\": [\"C\", \"A\"]}",
       "/joints/3: joint 'prismatic/ground/slider': the point 'C' is not carried by 'ground'"},
      {"{\"type\": \"revolute\", \"bodies\": [\"rod\", \"slider\"], \"points\": [\"C\"]},", "",
       "/points/C: point 'C': is carried by 'rod' and 'slider', but no joints say that these "
       "share it; add a joint there"},
      {"{\"name\": \"J1\"", "{\"name\": \"revolute/crank/rod\"", "accepted"},
      {"\"drivers\": [\"theta\"]", "\"drivers\": [\"theta\", \"theta\"]",
       "/drivers/1: names 'theta'"},
      {"\"drivers\": [\"theta\"]", "\"drivers\": [\"thta\"]",
       "/drivers/0: unknown coordinate 'thta'; did you mean 'theta'?"},
      {"\"drivers\": [\"theta\"]", "\"drivers\": \"theta\"", "/drivers: is a text; give a list"},
      {"\"angle\": [\"A\", \"B\"],", "", "/coordinates/theta: must measure one thing; "},
      {"\"angle\": [\"A\", \"B\"]", "\"angel\": [\"A\", \"B\"]",
       "/coordinates/theta/angel: unknown key 'angel'; did you mean 'angle'?"},
      {"\"angle\": [\"A\", \"B\"]", "\"angle\": [\"A\", \"B\"], \"along\": \"x\"",
       "/coordinates/theta/along: unknown key 'along'; "},
      {"\"angle\": [\"A\", \"B\"]", "\"angle\": [\"A\", \"B\"], \"towards\": \"x\"",
       "/coordinates/theta/towards: is for space"},
      {"\"angle\": [\"A\", \"B\"]", "\"angle\": [\"A\"]",
       "/coordinates/theta/angle: has 1 names; "},
      {"\"angle\": [\"A\", \"B\"]", "\"component\": \"A\", \"axis\": \"z\"",
       "/coordinates/theta/axis: there is no z in the plane; "},
      {"\"along\": \"x\"", "\"along\": \"y\"", "/coordinates/s/along: unknown vector 'y'; did you"},
      {"\"estimate\": 10", "\"estimate\": \"10\"", "/coordinates/theta/estimate: is a text; give"},
  };
  for (const auto& [old, by, message] : changes)
    expect_start(mechanism_complaint(replaced(slider_crank, old, by)),
                 message == "accepted" ? message : "m.json: " + message);
}

TEST(MechanismFile, WhatIsWrongInSpaceIsNamedToo) {
  const Change changes[] = {
      {"[\"v\", \"u\"]", "[\"v\"]", "/vectors/w/normal: has 1 directions; give two"},
      {"[\"v\", \"u\"]", "[\"u\", \"u\"]", "/vectors/w/normal: the two directions are parallel"},
      {"[\"v\", \"u\"]", "[\"w\", \"u\"]",
       "/vectors/w/normal: is defined by itself, a normal 'w' of 'w'; "},
      {"\"u\": [0, 0, 1]", "\"u\": {\"normal\": [\"w\", [\"A\", \"B\"]]}", "/vectors/"},
      {"\"C\": [2, 1, 0]", "\"C\": [1, 0, 0]", "/vectors/r/along: the points 'B' and 'C' coincide"},
      {"\"vectors\": [\"r\"]", "\"vectors\": []", "accepted"},
      {"\"crank\": {\"points\": [\"A\", \"B\"], \"vectors\": [\"u\"]",
       "\"crank\": {\"points\": [\"A\", \"B\"], \"vectors\": [\"u\", \"r\"]",
       "/vectors/r: vector 'r': is carried by 'crank' and 'rod', but no joints say"},
      {"\"points\": [\"A\"], \"vectors\": [\"u\"]}", "\"points\": [\"A\"], \"vectors\": [\"v\"]}",
       "/joints/0: joint 'revolute/ground/crank': the vector 'v' is not carried by 'crank'"},
      {"\"from\": \"-w\", ", "", "/coordinates/theta: the key 'from' is missing; add it"},
      {"\"from\": \"-w\"", "\"from\": \"-q\"", "/coordinates/theta/from: unknown vector 'q'; "},
      {"\"from\": \"-w\"", "\"from\": \"-v\"",
       "/coordinates/theta: coordinate 'theta': the directions where it is 0 and π/2 are not at a "
       "right angle"},
      {", \"towards\": \"v\"", "", "/coordinates/theta: the key 'towards' is missing; add it"},
      {"\"axis\": \"z\"", "\"axis\": \"q\"", "/coordinates/z/axis: unknown axis 'q'; "},
      {"\"vectors\": [\"u\", \"v\", \"w\"]", "\"vectors\": [\"u\", \"v\"]",
       "/coordinates/theta: coordinate 'theta': the vector 'w' is carried by no body; "},
  };
  for (const auto& [old, by, message] : changes)
    expect_start(mechanism_complaint(replaced(spatial, old, by)),
                 message == "accepted" ? message : "m.json: " + message);
  EXPECT_NE(mechanism_complaint(replaced(spatial, "\"u\": [0, 0, 1]",
                                         "\"u\": {\"normal\": [\"w\", [\"A\", \"B\"]]}"))
                .find("is defined by itself"),
            std::string::npos);
}

TEST(MechanismFile, ThatCannotBeReadSaysWhy) {
  const fs::path folder = fs::path(testing::TempDir()) / "desmo_files_test";
  fs::create_directories(folder);
  const auto complaint_of = [](const fs::path& file) {
    return complaint([&] { read_mechanism(file); });
  };
  const std::string missing = (folder / "missing.json").string();
  EXPECT_EQ(complaint_of(missing), missing + ": there is no such file; check its name and folder");
  EXPECT_EQ(complaint_of(folder), folder.string() + ": is a directory; give a file in it");
  EXPECT_NE(complaint_of("/dev/zero").find("is not a regular file; "), std::string::npos);
  const fs::path large = folder / "large.json";
  std::ofstream(large).close();
  fs::resize_file(large, (std::uintmax_t{64} << 20) + 1);
  EXPECT_NE(complaint_of(large).find("the file is larger than 64 MiB; "), std::string::npos);
  fs::remove_all(folder);
}

TEST(SceneFile, IsReadInSiUnits) {
  const std::string members = R"(
      "name": "one revolution", "units": {"angle": "deg", "length": "mm"},
      "motion": {"s": {"type": "table", "times": [-1, 0, 2, 3], "values": [100, 200, 300, 250]},
                 "theta": {"type": "harmonic", "mean": 90, "terms": [
                   {"amplitude": 180, "frequency": 2, "phase": 45}, {"amplitude": 1, "frequency": 3}]}},
      "time": {"start": -0.5, "end": 3, "step": 0.25},
      "formulation": "group_symbolic_explicit/guess:hermite5/lanes:8", "tolerance": 1e-8)";
  const std::string mechanism = replaced(slider_crank, "[\"theta\"]", "[\"s\", \"theta\"]");
  const Scene s = parse_scene(scene_of(mechanism, members), "s.json", "");
  EXPECT_EQ(s.name, "one revolution");
  EXPECT_EQ(s.formulation, "group_symbolic_explicit/guess:hermite5/lanes:8");
  EXPECT_EQ(s.tolerance, 1e-8);
  EXPECT_TRUE(s.request.empty());
  EXPECT_EQ(s.grid.instants, 15);
  EXPECT_DOUBLE_EQ(s.grid.time(14), 3);
  ASSERT_EQ(s.motions.size(), 2u);  // in the order of the coordinates, not of the drivers
  const auto& theta = std::get<HarmonicSum>(s.motions[0]);
  EXPECT_DOUBLE_EQ(theta.mean, std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(theta.terms[0].amplitude, std::numbers::pi);
  EXPECT_DOUBLE_EQ(theta.terms[0].angular_frequency, 4 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(theta.terms[0].phase, std::numbers::pi / 4);
  EXPECT_EQ(theta.terms[1].phase, 0);
  EXPECT_NEAR(sample(s.motions[1], 2.0).position, 0.3, 1e-15);
}

TEST(SceneFile, StartsFromALibraryMechanismOrAGenerator) {
  ASSERT_FALSE(library().empty());
  for (const LibraryMechanism& m : library()) {
    SCOPED_TRACE(m.name);
    const std::string name(m.name);
    const Scene own = parse_scene(m.scene, name, "");
    const Scene bare = parse_scene(scene_of("{\"library\": \"" + name + "\"}", ""), "s.json", "");
    EXPECT_EQ(own.mechanism.name, name);
    EXPECT_EQ(bare.mechanism.name, name);
    EXPECT_EQ(bare.motions.size(), own.motions.size());
    EXPECT_EQ(bare.grid.instants, own.grid.instants);
    EXPECT_EQ(find_library(name)->name, name);
    EXPECT_EQ(parse_mechanism(m.mechanism, name).points.size(), own.mechanism.points.size());
  }
  EXPECT_EQ(find_library("no such"), nullptr);
  for (const Case& c : cases()) {
    const std::string generator =
        "{\"generator\": \"" + std::string(c.name) + "\", \"" + std::string(c.unit_name) + "\": 3}";
    const Scene s = parse_scene(scene_of(generator, R"("time": {"end": 1, "step": 0.5})"), "", "");
    EXPECT_EQ(s.mechanism.bodies.size(), c.describe(3).mechanism.bodies.size());
    EXPECT_EQ(s.motions.size(), c.describe(3).motions.size());
    EXPECT_EQ(s.grid.instants, 3);
  }
}

TEST(SceneFile, FindsItsMechanismBesideIt) {
  const fs::path folder = fs::path(testing::TempDir()) / "desmo_scene_test";
  fs::create_directories(folder);
  std::ofstream(folder / "m.json") << slider_crank;
  std::ofstream(folder / "bad.json") << replaced(slider_crank, "[50, 0]", "[50]");
  std::ofstream(folder / "good.scene.json") << scene_of("\"m.json\"", driven);
  std::ofstream(folder / "bad.scene.json") << scene_of("\"bad.json\"", driven);
  std::ofstream(folder / "lost.scene.json") << scene_of("\"lost.json\"", driven);
  const auto complaint_of = [&](const char* file) {
    return complaint([&] { read_scene(folder / file); });
  };
  EXPECT_EQ(read_scene(folder / "good.scene.json").mechanism.name, "slider_crank");
  expect_start(complaint_of("bad.scene.json"),
               (folder / "bad.json").string() + ": /points/B: wrong dimension");
  expect_start(complaint_of("lost.scene.json"),
               (folder / "lost.scene.json").string() + ": /mechanism: the mechanism file '" +
                   (folder / "lost.json").string() + "': there is no such file; ");
  expect_start(scene_complaint(scene_of(R"("a\u0000b")", driven)),
               "s.json: /mechanism: 'a\\u0000b'");
  fs::remove_all(folder);
}

TEST(SceneFile, WhatIsWrongIsNamedWithItsPlaceAndRemedy) {
  const std::string good = scene_of(slider_crank, driven);
  ASSERT_EQ(scene_complaint(good), "accepted");
  const std::string coefficients = R"("type": "polynomial", "coefficients": [0, 360])";
  const Change changes[] = {
      {"[50, 0]", "[50]", "/mechanism/points/B: wrong dimension: "},
      {"desmo-scene", "desmo-mechanism", "/format: the format is 'desmo-mechanism', not"},
      {"\"motion\"", "\"motions\"", "/motions: unknown key 'motions'; did you mean 'motion'?"},
      {driven, time_of_one_second, "top level: the driven coordinate 'theta' has no motion; "},
      {"{\"theta\": {\"type", "{\"s\": {\"type", "/motion/s: the coordinate 's' is not driven; "},
      {"{\"theta\": {\"type", "{\"theta2\": {\"type",
       "/motion/theta2: unknown driven coordinate 'theta2'; did you mean 'theta'?"},
      {", " + time_of_one_second, "", "top level: the key 'time' is missing; add it"},
      {"\"step\": 0.01", "\"step\": 0", "/time/step: the step is not above 0; "},
      {"\"step\": 0.01", "\"step\": -1", "/time/step: the step is not above 0; "},
      {"\"step\": 0.01", "\"step\": 1e-10", "/time/step: gives more than 1e9 instants; "},
      {"\"step\": 0.01", "\"step\": 0.3", "/time/step: from start to end is not a whole number of"},
      {"\"step\": 0.01", "\"step\": 10", "/time/step: from start to end is not a whole number of"},
      {"\"end\": 1", "\"end\": 0", "/time/end: the end is not after the start; "},
      {"\"end\": 1", "\"start\": 1e20, \"end\": 2e20", "/time/step: gives more than 1e9 instants"},
      {"\"polynomial\"", "\"spline\"", "/motion/theta/type: unknown type of motion 'spline'; "},
      {"[0, 360]", "[]", "/motion/theta/coefficients: has 0 coefficients; "},
      {"\"coefficients\"", "\"values\"", "/motion/theta/values: unknown key 'values'; "},
      {coefficients, R"("type": "harmonic", "terms": [])", "/motion/theta/terms: has no terms; "},
      {coefficients, R"("type": "harmonic", "terms": [{"frequency": 1}])",
       "/motion/theta/terms/0: the key 'amplitude' is missing; add it"},
      {coefficients, R"("type": "table", "times": [0, 1, 1], "values": [1, 2, 3])",
       "/motion/theta/times/2: is not after the time before it; "},
      {coefficients, R"("type": "table", "times": [0], "values": [1])",
       "/motion/theta/times: has 1 times; a table needs 2 or more"},
      {coefficients, R"("type": "table", "times": [0, 1], "values": [1, 2, 3])",
       "/motion/theta/values: has 3 values for 2 times; "},
      {coefficients, R"("type": "table", "times": [0, 1], "values": [1, 2], "ends": "free")",
       "/motion/theta/ends: unknown ends 'free'; there are 'natural', 'clamped', 'periodic'"},
      {coefficients,
       R"("type": "table", "times": [0, 0.5, 1], "values": [1, 2, 3], "ends": "periodic")",
       "/motion/theta: a table of times and values that is periodic must end with"},
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
      {R"("request": [{"everything": true, "points": ["A"]}])",
       "/request/0: asks for everything and more; "},
  };
  for (const auto& [member, message] : members)
    expect_start(scene_complaint(scene_of(slider_crank, driven + ", " + member)),
                 std::string("s.json: ") + message);
  const std::string free = replaced(slider_crank, "\"mm\"", "\"1\"");
  EXPECT_EQ(scene_complaint(scene_of(free, driven)), "accepted");
  expect_start(scene_complaint(scene_of(free, driven + R"(, "units": {"length": "mm"})")),
               "s.json: /units/length: the mechanism's unit of length is '1', any one unit; ");
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

// Names with the level, in the order of the request.
std::vector<std::string> requested(const std::string& request) {
  const Scene s = parse_scene(scene_of(slider_crank, driven + ", \"request\": " + request), "", "");
  std::vector<std::string> names;
  for (const Wanted& w : s.request) {
    const Description& d = s.mechanism;
    names.push_back((w.kind == Wanted::Kind::point    ? d.points[w.index].name
                     : w.kind == Wanted::Kind::vector ? d.vectors[w.index].name
                                                      : d.coordinates[w.index].name) +
                    " " + std::to_string(static_cast<int>(w.level)));
  }
  return names;
}

TEST(SceneFile, RequestsAreExpandedAndHaveNothingTwice) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(requested(R"([{"points": ["C"], "level": "velocity"}])"), (Names{"C 1"}));
  EXPECT_EQ(requested(R"([{"points": ["B", "B"]}, {"points": ["*"], "level": "acceleration"},
                          {"bodies": ["crank"], "level": "velocity"}])"),
            (Names{"B 2", "A 2", "C 2"}));
  EXPECT_EQ(requested(R"([{"bodies": ["s*r"], "distances": ["s"]}, {"angles": ["th*"]}])"),
            (Names{"s 0", "C 0", "x 0", "theta 0"}));
  EXPECT_EQ(requested(R"([{"everything": true, "level": "velocity"}])"),
            (Names{"A 1", "B 1", "C 1", "x 1", "theta 1", "s 1"}));
}

TEST(SceneFile, WhatNoBodyCarriesCannotBeAskedFor) {
  const std::string more = replaced(slider_crank, "\"A\": [0, 0]", "\"A\": [0, 0], \"O\": [9, 9]");
  const std::string ask = driven + R"(, "request": [{"points": [")";
  EXPECT_EQ(parse_scene(scene_of(more, ask + R"(*"]}])"), "", "").request.size(), 3u);
  expect_start(scene_complaint(scene_of(more, ask + R"(O"]}])")),
               "s.json: /request/0/points/0: 'O' is carried by no body and has no motion; ");
}

TEST(Names, NearestComeFirstAndInOrder) {
  using Names = std::vector<std::string_view>;
  const Names known{"C2", "rod", "C", "theta", "D"};
  EXPECT_EQ(nearest_names("C1", known), (Names{"C2", "C"}));
  EXPECT_EQ(nearest_names("tehta", known), (Names{"theta"}));
  EXPECT_EQ(nearest_names("something", known), Names{});
  EXPECT_EQ(nearest_names("X", Names{"A", "B", "C", "D"}), (Names{"A", "B", "C"}));
  EXPECT_EQ(suggestion("C1", known), "did you mean 'C2', 'C'?");
  EXPECT_EQ(suggestion("something", Names{}), "there are none");
}

TEST(Names, PatternsMatchAnyCharacters) {
  EXPECT_TRUE(matches("*", ""));
  EXPECT_TRUE(matches("axle*/S", "axle12/S"));
  EXPECT_TRUE(matches("*a*b*", "xxaxxbxx"));
  EXPECT_TRUE(matches("a**", "a"));
  EXPECT_FALSE(matches("axle*/S", "axle12/St"));
  EXPECT_FALSE(matches("", "a"));
  EXPECT_FALSE(matches(std::string(50, '*') + "b", std::string(100, 'a')));
}

TEST(Names, AreShownSafely) {
  EXPECT_EQ(printable("größe"), "größe");
  EXPECT_EQ(printable("a\x1b[0m\n"), "a\\u001b[0m\\u000a");
  EXPECT_EQ(printable("\xff\xc3"), "\\xff\\xc3");
  EXPECT_EQ(printable("\u202egpj"), "\\u202egpj");
  EXPECT_EQ(printable("ää", 1), "ä...");
}

TEST(Description, OfManyBodiesIsCheckedAndReadQuickly) {
  const auto start = std::chrono::steady_clock::now();
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
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  EXPECT_LT(seconds.count(), 10);  // generous, for sanitizers; quadratic work would take longer
}

// Every normal but the last waits for the next: resolving must not recurse, nor take quadratic
// time.
TEST(MechanismFile, LongChainsOfDefinitionsAreResolved) {
  constexpr int length = 20'000;
  const auto chain = [&](const std::string& last) {
    std::string vectors;
    for (int i = 0; i < length; ++i)
      vectors += "\"n" + std::to_string(i) + "\": {\"normal\": [\"n" + std::to_string(i + 1) +
                 "\", \"" + (i % 2 ? "b" : "a") + "\"]}, ";
    const std::string end = "\"n" + std::to_string(length) + "\": " + last;
    return replaced(spatial, "\"u\": [0, 0, 1]",
                    "\"u\": [0, 0, 1], \"a\": [1, 0, 0], \"b\": [0, 1, 0], " + vectors + end);
  };
  const std::string parallel = mechanism_complaint(chain("[0, 0, 1]"));
  EXPECT_NE(parallel.find("parallel"), std::string::npos) << parallel;
  const std::string cyclic = mechanism_complaint(chain("{\"normal\": [\"n0\", \"a\"]}"));
  EXPECT_NE(cyclic.find("is defined by itself"), std::string::npos) << cyclic;
  EXPECT_LT(cyclic.size(), 300u);
}

// Whatever is done to a good file, it is read or refused, never anything else.
TEST(Files, SurviveRandomDamage) {
  std::mt19937 random(1);
  const std::string scene = scene_of(spatial, driven + R"(, "request": [{"points": ["*"]}])");
  const std::string bits[] = {"\"",      "{",    "}", "[",      "]",     ",",
                              ":",       "-",    "0", "1e308",  "null",  "\"u\"",
                              "\\u0000", "\xff", "*", "normal", "along", "[\"A\", \"B\"]"};
  int accepted = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string text = scene;
    for (auto changes = random() % 4 + 1; changes > 0; --changes) {
      const std::size_t at = random() % text.size(), length = random() % 8;
      text.replace(at, std::min(length, text.size() - at),
                   random() % 2 ? bits[random() % std::size(bits)]
                                : text.substr(random() % text.size(), random() % 12));
    }
    const std::string message = scene_complaint(text);
    accepted += message == "accepted";
    if (message != "accepted") expect_start(message, "s.json: ");
  }
  EXPECT_LT(accepted, 3000);
}

}  // namespace
}  // namespace desmo
