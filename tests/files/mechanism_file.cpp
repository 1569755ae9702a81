// Mechanism files: what is read.

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/float128.hpp>
#include <cmath>
#include <numbers>

#include "cases/mechanism/mechanism.h"
#include "cases/numbers/space.h"
#include "tests/files/common.h"

namespace desmo::mechanism_file_test {
namespace {

TEST(MechanismFile, IsReadInSiUnitsAndInItsOrder) {
  const Mechanism mechanism = parse_mechanism(slider_crank, "m.json");
  EXPECT_EQ(mechanism.name, "slider_crank");
  EXPECT_EQ(mechanism.dimension, 2);
  EXPECT_EQ(mechanism.length_unit, "m");
  ASSERT_EQ(mechanism.points.size(), 3u);
  EXPECT_EQ(mechanism.points[2].name, "C");
  EXPECT_DOUBLE_EQ(mechanism.points[2].position[0], 0.2);
  EXPECT_DOUBLE_EQ(mechanism.vectors[0].direction[0], 1);
  ASSERT_EQ(mechanism.bodies.size(), 4u);
  EXPECT_EQ(mechanism.bodies[0].name, "ground");
  EXPECT_EQ(mechanism.bodies[3].name, "slider");
  EXPECT_DOUBLE_EQ(mechanism.bodies[2].length.value().value, 0.15);
  EXPECT_EQ(mechanism.bodies[2].points, (std::vector{1, 2}));
  ASSERT_EQ(mechanism.joints.size(), 4u);
  EXPECT_EQ(mechanism.joints[0].name, "J1");
  EXPECT_EQ(mechanism.joints[1].name, "revolute/crank/rod");
  EXPECT_EQ(mechanism.joints[3].type, Mechanism::JointType::prismatic);
  EXPECT_EQ(mechanism.joints[3].bodies, (std::array{0, 3}));
  EXPECT_EQ(mechanism.joints[3].points, (std::vector{0, 2}));
  ASSERT_EQ(mechanism.coordinates.size(), 2u);
  EXPECT_TRUE(mechanism.coordinates[0].driven);
  EXPECT_FALSE(mechanism.coordinates[1].driven);
  EXPECT_NEAR(mechanism.coordinates[0].estimate.value(), std::numbers::pi / 18, 1e-15);
  EXPECT_DOUBLE_EQ(mechanism.coordinates[1].estimate.value(), 0.201);
  EXPECT_EQ(mechanism.coordinates[1].type, Mechanism::CoordinateType::along);
}

TEST(MechanismFile, MayHaveComments) {
  const std::string noted = replaced(replaced("// of Größe 2\n/* \"units\": */" + slider_crank,
                                              "[50, 0]", "[50, /* y: */ 0] /*\"*/"),
                                     "\"slider_crank\"", "\"a//b\"");
  EXPECT_EQ(parse_mechanism(noted, "").name, "a//b");
  EXPECT_EQ(parse_mechanism(noted, "").points[1].position[0], 50e-3);
  expect_start(mechanism_complaint("/* ü\n */ {\"a\": /**/ // ]\n  ]}"),
               "m.json: line 3, column 3: ");
  expect_start(mechanism_complaint("{\"a\": 1} /* no end"),
               "m.json: line 1, column 10: is no comment");
  expect_start(mechanism_complaint("{\"a\": 1 / 2}"), "m.json: line 1, column 9: is no comment");
  expect_start(mechanism_complaint("{\"a\": 1} /*/"), "m.json: line 1, column 10: is no comment");
  expect_start(mechanism_complaint("// nothing"), "m.json: top level: the text is empty");
  EXPECT_CONTAINS(mechanism_complaint("{} //\xff\n]"), "line 2, column 1");
}

TEST(MechanismFile, DirectionsAreDefinedInAnyOrder) {
  const Mechanism mechanism = parse_mechanism(spatial, "m.json");
  const auto expect_direction = [&](int i, double x, double y, double z) {
    EXPECT_NEAR(mechanism.vectors[i].direction[0], x, 1e-15) << i;
    EXPECT_NEAR(mechanism.vectors[i].direction[1], y, 1e-15) << i;
    EXPECT_NEAR(mechanism.vectors[i].direction[2], z, 1e-15) << i;
  };
  expect_direction(0, 1, 0, 0);
  expect_direction(1, 0, 1, 0);
  expect_direction(3, std::sqrt(0.5), std::sqrt(0.5), 0);
  EXPECT_EQ(mechanism.vectors[3].along.value(), (std::array{1, 2}));
  EXPECT_FALSE(mechanism.vectors[0].along);
  EXPECT_TRUE(mechanism.coordinates[0].opposite);
  EXPECT_EQ(mechanism.coordinates[0].from.vector, 0);
  EXPECT_EQ(mechanism.coordinates[0].towards.vector, 1);
  EXPECT_EQ(mechanism.coordinates[1].axis, 2);
}

/// The product of the two lines' lengths is below the least double.
TEST(MechanismFile, NormalsOfShortLinesHaveRemainders) {
  const Mechanism mechanism = parse_mechanism(R"({
    "format": "desmo-mechanism", "version": 1, "name": "short", "dimension": 3,
    "points": {"A": [0, 0, 0], "B": [3e-200, 1e-200, 0], "C": [0, 1e-200, 7e-200]},
    "vectors": {"n": {"normal": [["A", "B"], ["A", "C"]]}},
    "ground": {"points": ["A", "C"], "vectors": ["n"]},
    "bodies": {"crank": {"points": ["A", "B"], "vectors": ["n"]}},
    "joints": [{"type": "revolute", "bodies": ["ground", "crank"], "points": ["A"],
                "vectors": ["n"]}]})",
                                              "m.json");
  EXPECT_NEAR(mechanism.vectors[0].direction[0], 7 / std::sqrt(499), 1e-15);
  for (const Remainder& r : mechanism.vectors[0].remainder) {
    EXPECT_LE(std::abs(r.correction), 0x1p-53);
    EXPECT_LT(r.radius, 1e-29);
  }
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
  EXPECT_CONTAINS(parallel, "parallel");
  const std::string cyclic = mechanism_complaint(chain("{\"normal\": [\"n0\", \"a\"]}"));
  EXPECT_CONTAINS(cyclic, "is defined by itself");
  EXPECT_LT(cyclic.size(), 300u);
}

/// Rounded coordinates would lose 1e-10 m here, far from the frame's origin.
TEST(MechanismFile, PlacesFramesExactly) {
  using Wide = boost::multiprecision::float128;
  const Mechanism m = parse_mechanism(R"({"format": "desmo-mechanism", "version": 1, "name": "far",
    "dimension": 3, "units": {"length": "mm", "angle": "deg"}, "points": {"A": [1, 2, 3]},
    "ground": {"points": ["A"]},
    "bodies": {"b": {"at": [-1e9, 3, 1e8, 20, 30, -50],
                     "points": {"A": [1e9, 1, 2], "B": [1000000003, 1, 4]},
                     "vectors": {"u": [1, 2, 2]}}},
    "joints": [{"type": "spherical", "bodies": ["ground", "b"], "points": ["A"]}]})",
                                      "m.json");
  const Wide degree = acos(Wide(-1)) / 180, angle = sqrt(Wide(3800));
  const auto turned = [&](const std::array<Wide, 3>& x) {
    return turned_about<Wide>({20 / angle, 30 / angle, -50 / angle}, degree * angle, x);
  };
  const std::array<Wide, 3> b = turned({3, 0, 2}), u = turned({1, 2, 2});
  constexpr double max_radius = 1e-13;  // 1e6 m times the error of sines, 2^-68, and its sums
  for (int i = 0; i < 3; ++i) {
    const Derived x = m.points[1].exact()[i], e = m.vectors[0].exact()[i];
    EXPECT_LE(x.radius, max_radius);
    EXPECT_LE(e.radius, 1e-19);
    EXPECT_LE(double(abs(as<Wide>(x) - (1 + i + b[i]) * Wide(1e-3))), x.radius + 1e-25);
    EXPECT_LE(double(abs(as<Wide>(e) - u[i] / 3)), e.radius + 1e-30);
  }
}

}  // namespace
}  // namespace desmo::mechanism_file_test
