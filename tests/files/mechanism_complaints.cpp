// Refusals of mechanism files, each with the file, the place, the fault and a remedy.

#include <gtest/gtest.h>

#include <tuple>

#include "tests/files/common.h"

namespace desmo::mechanism_complaints_test {
namespace {

TEST(MechanismFile, CouplingsThatAreWrongAreNamed) {
  const std::string both = R"("coordinate": "s", "of": "theta")", at = R"(, "at": [0, 90, 360])",
                    values = R"(, "values": [5, 7, 5])";
  const std::pair<std::string, const char*> faults[] = {
      {both + at + values + R"(, "ends": "periodic", "from": 145)", nullptr},
      {R"("sum": {"theta": 5, "s": -360})", nullptr},
      {R"("sum": {"theta": 5})", ": coupling 'c': relates 1 coordinate; give two to four"},
      {R"("sum": {"thta": 5, "s": 1})",
       "/sum/thta: unknown coordinate 'thta'; did you mean 'theta'?"},
      {R"("sum": {"theta": 0, "s": 1})",
       ": coupling 'c': the factor of 'theta' is 0 or not finite; give another number"},
      {R"("product": {})",
       "/product: unknown key 'product'; there are 'sum', 'coordinate', 'of', 'at', 'values'"},
      {both + at + values + R"(, "ends": "indexing", "from": "drawing")", nullptr},
      {R"("coordinate": "s")" + at + values, ": the key 'of' is missing; add it"},
      {R"("of": "theta")" + at + values, ": the key 'coordinate' is missing; add it"},
      {both + values, ": the key 'at' is missing; add it"},
      {both + at, ": the key 'values' is missing; add it"},
      {both + at + values + R"(, "times": [])", "/times: unknown key 'times'"},
      {both + at + values + R"(, "sum": {})", "/sum: unknown key 'sum'"},
      {R"("coordinate": "S", "of": "theta")" + at + values, "/coordinate: unknown coordinate 'S'"},
      {R"("coordinate": "s", "of": "thta")" + at + values,
       "/of: unknown coordinate 'thta'; did you mean 'theta'?"},
      {R"("coordinate": "s", "of": "s")" + at + values, ": coupling 'c': lists 's' twice"},
      {both + R"(, "at": [], "values": [])", "/at: has 0 numbers; a table needs 2 or more"},
      {both + R"(, "at": [0, 90])" + values, "/values: has 3 numbers, and 'at' 2; give as many"},
      {both + R"(, "at": [0, 90, 90])" + values,
       "/at/2: is not above the number before it; give ascending ones"},
      {both + at + values + R"(, "ends": "free")",
       "/ends: unknown ends 'free'; there are 'natural', 'clamped', 'periodic', 'indexing'"},
      {both + at + R"(, "values": [5, 7, 6], "ends": "periodic")",
       ": coupling 'c': a table that is periodic must end with the value it begins with; change"},
      {both + R"(, "at": [0, 90], "values": [5, 7], "ends": "indexing")",
       ": coupling 'c': a table with these ends needs three points or more; change"},
      {both + at + values + R"(, "from": "start")",
       "/from: unknown start 'start'; there are 'drawing'"},
      {both + at + values + R"(, "file": "t.csv")", ": has a file, and lists as well; give one"},
      {both + R"(, "file": "")", "/file: '' is no file name; give that of a table file"},
      {both + R"(, "file": "none.csv")", "/file: the table file 'none.csv'"},
  };
  for (const auto& [members, message] : faults)
    expect_start(
        mechanism_complaint(replaced(slider_crank, "\"drivers\": [",
                                     "\"couplings\": {\"c\": {" + members + "}}, \"drivers\": [")),
        message ? "m.json: /couplings/c" + std::string(message) : "accepted");
}

TEST(MechanismFile, WhatIsWrongIsNamedWithItsPlaceAndRemedy) {
  const std::string crank = R"("crank": {"points": ["A", "B"]})", angle = R"("angle": ["A", "B"])",
                    second_joint = R"("type": "revolute", "bodies": ["crank")",
                    shared_point = R"(["crank", "rod"], "points": ["B"])";
  const Change changes[] = {
      {"desmo-mechanism", "desmo-mechanisms", "/format: the format is 'desmo-mechanisms', not"},
      {"desmo-mechanism", "desmo-scene", "/format: the format is 'desmo-scene', not"},
      {R"("format": "desmo-mechanism",)", "", "top level: the key 'format' is missing; add it"},
      {"\"version\": 1", "\"version\": 2", "/version: this version of the format is not known; "},
      {"\"version\": 1", R"("version": "1")", "/version: is a text; give a number"},
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
      {"\"slider_crank\"", "\"slider:crank\"", "/name: 'slider:crank' is not a name; use "},
      {"\"C\": [200", "\"d/dt C\": [200", "/points/d~1dt C: 'd/dt C' is not a name; "},
      {"\"C\": [200", "\"\": [200", "/points/: '' is not a name; "},
      {"[2, 0]", "[0, 0]", "/vectors/x: a direction of length 0; "},
      {"[2, 0]", R"({"normal": ["x", "x"]})", "/vectors/x/normal: a normal needs three dim"},
      {"[2, 0]", R"({"along": ["A", "A"]})", "/vectors/x/along: names the point 'A' twice; "},
      {"[2, 0]", "{}", "/vectors/x: defines a direction by both or neither of normal and along; "},
      {"[2, 0]", "\"y\"", "/vectors/x: is no direction; "},
      {crank, R"("crank": {"points": ["A", "B1"]})",
       "/bodies/crank/points/1: unknown point 'B1'; did you mean 'B'?"},
      {crank, R"("crank": {"points": ["A", "B", "B"]})",
       "/bodies/crank: body 'crank': lists the point 'B' twice; "},
      {crank, R"("crank": {"points": {"A": [0, 0], "B": [50, 0]}})",
       "/bodies/crank: the key 'at' is missing; add it"},
      {crank, R"("crank": {"at": [0, 0], "points": {"A": [0, 0]}})",
       "/bodies/crank/at: has 2 numbers; give the origin and the angle: three"},
      {crank, R"("crank": {"at": [0, 0, 0], "points": ["A", "B"]})",
       "/bodies/crank/points: is a list; give an object"},
      {crank, R"("crank": {"at": [0, 0, 0], "points": {"A": [0, 0], "B": [50, 0, 1]}})",
       "/bodies/crank/points/B: wrong dimension: has 3 components"},
      {crank, R"("crank": {"at": [0, 0, 0], "points": {"A": [9, 9], "B": [9, 9]}})",
       "/bodies/crank: body 'crank': all its points coincide"},
      {crank, R"("crank": {"at": [0, 0, 0], "points": {"A": [0, 0], "B1": [50, 0]}})",
       "/joints/1: joint 'revolute/crank/rod': the point 'B' is not carried by 'crank'; "},
      {crank, R"("crank": {"at": [0, 0, 0], "points": {"A": [0, 0], "B": [50, 0], "E": [9, 9]}},
          "plate": {"points": ["A", "E"]})",
       "/bodies/plate/points/1: the point 'E' is given in the frame of another body only, which is "
       R"(an estimate; add it to the file's "points", or give this body a frame, too, by "at")"},
      {R"("slider": {"points": ["C"], "vectors": ["x"]})",
       R"("slider": {"at": [190, 8, 5], "points": {"C": [0, 0]}, "vectors": {"x": [1, 0]}})",
       "accepted"},
      {"\"crank\": {", "\"ground\": {", "/bodies/ground: 'ground' is the name of the ground; "},
      {"\"crank\": {", "\"A\": {", "/joints/0/bodies/1: unknown body 'crank'; "},
      {"\"s\": {", "\"A\": {", "/coordinates/A: coordinate 'A': the name is given twice among"},
      {"\"length\": 150", "\"length\": 0", "/bodies/rod: body 'rod': the length is not above 0; "},
      {"\"C\": [200, 0]", "\"C\": [50, 0]", "/bodies/rod: body 'rod': its points 'B' and 'C' coin"},
      {R"({"points": ["C"], "vectors": ["x"]})",
       R"({"points": ["C"], "vectors": ["x"], "length": 1})",
       "/bodies/slider: body 'slider': has a length but 1 points; "},
      {R"("ground": {"points": ["A"],)", R"("ground": {"length": 1, "points": ["A"],)",
       "/ground/length: unknown key 'length'; "},
      {"\"joints\"", "\"units2\"", "/units2: unknown key 'units2'; did you mean 'units'"},
      {second_joint, R"("type": "revolut", "bodies": ["crank")",
       "/joints/1/type: unknown type of joint 'revolut'; did you mean 'revolute'?"},
      {second_joint, R"("type": "pin", "length": 1, "bodies": ["crank")",
       "/joints/1/type: unknown type of joint 'pin'; there are 'revolute', 'prismatic', "
       "'revolute_on_slider', 'fixed'"},
      {second_joint, R"("bodies": ["crank")", "/joints/1: the key 'type' is missing; add it"},
      {second_joint, R"("type": "spherical", "bodies": ["crank")",
       "/joints/1: joint 'spherical/crank/rod': spherical joints exist only in space"},
      {R"(["crank", "rod"])", "[\"crank\"]", "/joints/1/bodies: has 1 names; give two"},
      {R"(["crank", "rod"])", R"(["crank", "crank"])", "/joints/1/bodies: names the body 'crank'"},
      {shared_point, R"(["crank", "rod"], "points": ["C"])",
       "/joints/1: joint 'revolute/crank/rod': the point 'C' is not carried by 'crank'; revolute"},
      {shared_point, R"(["crank", "rod"])",
       "/joints/1: joint 'revolute/crank/rod': has 0 points and 0 vectors; revolute takes one"},
      {R"("points": ["A", "C"]})", R"("points": ["A", "A"]})",
       "/joints/3: joint 'prismatic/ground/slider': lists the point 'A' twice; "},
      {R"("points": ["A", "C"]})", R"("points": ["C", "A"]})",
       "/joints/3: joint 'prismatic/ground/slider': the point 'C' is not carried by 'ground'"},
      {R"({"type": "revolute", "bodies": ["rod", "slider"], "points": ["C"]},)", "",
       "/points/C: point 'C': is carried by 'rod' and 'slider', but no joints say that these "
       "share it; add a joint there"},
      {R"({"name": "J1")", R"({"name": "revolute/crank/rod")", "accepted"},
      {R"("drivers": ["theta"])", R"("drivers": ["theta", "theta"])", "/drivers/1: names 'theta'"},
      {R"("drivers": ["theta"])", R"("drivers": ["thta"])",
       "/drivers/0: unknown coordinate 'thta'; did you mean 'theta'?"},
      {R"("drivers": ["theta"])", R"("drivers": "theta")", "/drivers: is a text; give a list"},
      {R"("angle": ["A", "B"],)", "", "/coordinates/theta: must measure one thing; "},
      {angle, R"("angel": ["A", "B"])",
       "/coordinates/theta/angel: unknown key 'angel'; did you mean 'angle'?"},
      {angle, R"("angle": ["A", "B"], "along": "x")",
       "/coordinates/theta/along: unknown key 'along'; "},
      {angle, R"("angle": ["A", "B"], "towards": "x")", "/coordinates/theta/towards: is for space"},
      {angle, R"("angle": ["A", "B"], "from": ["B", "A"])",
       "/coordinates/theta: coordinate 'theta': is an angle between a direction and itself"},
      {angle, R"("angle": ["A"])", "/coordinates/theta/angle: has 1 names; "},
      {angle, R"("component": "A", "axis": "z")",
       "/coordinates/theta/axis: there is no z in the plane; "},
      {R"("along": "x")", R"("along": "y")",
       "/coordinates/s/along: unknown vector 'y'; there are 'x'"},
      {"\"estimate\": 10", R"("estimate": "10")", "/coordinates/theta/estimate: is a text; give"},
  };
  for (const auto& [old, by, message] : changes)
    expect_start(mechanism_complaint(replaced(slider_crank, old, by)),
                 message == "accepted" ? message : "m.json: " + message);
}

TEST(MechanismFile, JointsThatAreCouplingsAreShownInTheUnitsOfTheFile) {
  const std::tuple<const char*, const char*, const char*> joints[] = {
      {"gear", "deg", R"({"wheel1": 20, "wheel2": 40}}} (teeth))"},
      {"belt", "rad", R"({"pulley1": 60, "pulley2": -30}}} (radii))"},
      {"rack", "deg", R"({"pinion": 94.24777960769379, "travel": -360}}} (a pinion of radius 15))"},
      {"rack", "rad", R"({"pinion": 15, "travel": -1}}} (a pinion of radius 15))"},
      {"screw", "deg", R"({"turn": 5, "travel": -360}}} (5 a turn))"},
      {"screw", "rad", R"({"turn": 5, "travel": -6.283185307179586}}} (5 a turn))"},
  };
  for (const auto& [type, unit, sum] : joints)
    EXPECT_EQ(
        mechanism_complaint(replaced(
            replaced(slider_crank, "\"deg\"", "\"" + std::string(unit) + "\""),
            "{\"type\": \"revolute\"", "{\"type\": \"" + std::string(type) + "\", \"ratio\": 1")),
        "m.json: /joints/1/type: '" + std::string(type) +
            "' is a coupling of coordinates and no joint; join the bodies to what carries "
            "them, declare a coordinate of each, and give \"couplings\": {\"name\": "
            "{\"sum\": " +
            sum);
}

TEST(MechanismFile, WhatIsWrongInSpaceIsNamedToo) {
  const std::string rod = R"("rod": {"points": ["B", "C"], "vectors": ["r"]})";
  const Change changes[] = {
      {"\"spherical\"", "\"ball\"",
       "/joints/1/type: unknown type of joint 'ball'; there are 'revolute', 'prismatic', "
       "'cylindrical', 'universal', 'spherical', 'fixed', 'hinge', 'point_on_line', "
       "'point_on_plane', 'planar'"},
      {R"("towards": "v")", R"("towards": "-v")",
       "/coordinates/theta/towards: an opposite such as '-v' is taken by \"from\" alone; "},
      {R"(["v", "u"])", "[\"v\"]", "/vectors/w/normal: has 1 directions; give two"},
      {R"(["v", "u"])", R"(["u", "u"])", "/vectors/w/normal: the two directions are parallel"},
      {R"(["v", "u"])", R"(["w", "u"])",
       "/vectors/w/normal: is defined by itself, a normal 'w' of 'w'; "},
      {"\"u\": [0, 0, 1]", R"("u": {"normal": ["w", ["A", "B"]]})",
       "/vectors/w/normal: is defined by itself, a normal 'w' of 'v' of 'u' of 'w'; "},
      {"\"C\": [2, 1, 0]", "\"C\": [1, 0, 0]", "/vectors/r/along: the points 'B' and 'C' coincide"},
      {R"("vectors": ["r"])", "\"vectors\": []", "accepted"},
      {rod, R"("rod": {"at": [1, 0, 0, 0, 0], "points": {"B": [0, 0, 0], "C": [1, 0, 0]}})",
       "/bodies/rod/at: has 5 numbers; give the origin and the rotation vector: six"},
      {rod, R"("rod": {"at": [1, 0, 0, 0, 0, 0.7], "points": {"B": [0, 0, 0], "C": [1.4, 0, 0]},
          "vectors": {"r": {"along": ["B", "C"]}, "q": {"normal": ["r", "r"]}}})",
       "/bodies/rod/vectors/q/normal: the two directions are parallel"},
      {rod, R"("rod": {"at": [1, 0, 0, 0, 0, 0.7], "points": {"B": [0, 0, 0], "C": [1.4, 0, 0]},
          "vectors": {"r": {"along": ["B", "C"]}}})",
       "accepted"},
      {R"("crank": {"points": ["A", "B"], "vectors": ["u"])",
       R"("crank": {"points": ["A", "B"], "vectors": ["u", "r"])",
       "/vectors/r: vector 'r': is carried by 'crank' and 'rod', but no joints say"},
      {R"("points": ["A"], "vectors": ["u"]})", R"("points": ["A"], "vectors": ["v"]})",
       "/joints/0: joint 'revolute/ground/crank': the vector 'v' is not carried by 'crank'"},
      {R"("from": "-w", )", "", "/coordinates/theta: an angle in space needs the vectors where"},
      {R"("from": "-w")", R"("from": "-q")", "/coordinates/theta/from: unknown vector 'q'; "},
      {R"("from": "-w")", R"("from": "-v")",
       "/coordinates/theta: coordinate 'theta': the directions where it is 0 and π/2 are not at a "
       "right angle"},
      {R"(, "towards": "v")", "", "/coordinates/theta: an angle in space needs the vectors where"},
      {R"("angle": ["A", "B"])", R"("angle": "v")",
       "/coordinates/theta: coordinate 'theta': is an angle between a direction and itself"},
      {R"("angle": ["A", "B"])", R"("angle": "u")",
       "/coordinates/theta: coordinate 'theta': 'u' is perpendicular to the plane of 'w' and 'v'"},
      {R"("axis": "z")", R"("axis": "q")", "/coordinates/z/axis: unknown axis 'q'; "},
      {R"("vectors": ["u", "v", "w"])", R"("vectors": ["u", "v"])",
       "/coordinates/theta: coordinate 'theta': the vector 'w' is carried by no body; "},
  };
  for (const auto& [old, by, message] : changes)
    expect_start(mechanism_complaint(replaced(spatial, old, by)),
                 message == "accepted" ? message : "m.json: " + message);
}

}  // namespace
}  // namespace desmo::mechanism_complaints_test
