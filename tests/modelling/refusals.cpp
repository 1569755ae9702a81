// Refusals, by name, of mechanisms that their drivers do not determine.

#include <gtest/gtest.h>

#include "cases/io/files.h"
#include "cases/mechanism/formatted.h"
#include "formulations/model/plan.h"
#include "tests/contains.h"
#include "tests/modelling/common.h"
#include "tests/overconstrained.h"
#include "tests/refusal.h"

namespace desmo::refusals_test {
namespace {

TEST(Refused, LinkOfZeroLength) {
  Mechanism mechanism = four_bar_sketch().release_pinned();
  mechanism.points[3].position = mechanism.points[2].position;  // C at B
  expect_refused(driven(std::move(mechanism), {"theta"}), turning, {"'coupler'", "zero length"});
}

TEST(Refused, ThirdCrankOfAnotherLength) {
  expect_refused(parallelogram({0, 2, 5}, 1, 1.3), turning,
                 {"contradict each other as it moves", "crank3", "coupler", "'theta'"});
}

/// Cranks of 1 on a coupler of 5: the limit is an error of 0.0075, which all of them share.
TEST(Refused, ThirdCrankThatContradictsByMoreThanTheLimit) {
  for (const double off : {2e-2, -2e-2})
    expect_refused(parallelogram({0, 2, 5}, 1, 1 + off), turning,
                   {"contradict each other as it moves: with its drivers ('theta') moved by ",
                    "0.1 rad, '", "' is off by ", " at best"});
  for (const double off : {1e-9, 1e-6, -1e-5, 2e-3})
    EXPECT_NO_THROW(model_mechanism(parallelogram({0, 2, 5}, 1, 1 + off), turning)) << off;
}

TEST(Refused, LinkagesThatCloseToThreeDigits) {
  for (const long double start : {0.83L, 1.24L, 1.65L}) {
    EXPECT_THROW(make_model(bennett(start, 3)), std::invalid_argument);
    EXPECT_THROW(make_model(parallel_cranks(start, 2, true)), std::invalid_argument);
    EXPECT_THROW(make_model(parallel_cranks(start, 2, false)), std::invalid_argument);
  }
}

TEST(Refused, TooManyDrivers) {
  expect_refused(
      driven(four_bar_sketch().release_pinned(), {"theta", "psi"}), {still, still},
      {"over-constrained", "crank", "coupler", "rocker", "'theta'", "'psi'", "too many drivers"});
}

TEST(Refused, MissingDriver) {
  const Mechanism mechanism = four_bar_sketch().release_pinned();
  expect_refused(mechanism, {},
                 {"under-constrained", "'crank'", "'coupler'", "'rocker'",
                  "add a driver, such as 'theta', or a joint"});
  // In the plane a rod between two pins cannot spin about their line.
  EXPECT_LACKS(refusal([&] { model_mechanism(mechanism, {}); }), "spin");
}

TEST(Refused, FiveBarDrivenTwiceAtOneCrank) {
  Sketch d("five-bar", 2);
  const int A = d.ground_point("A", {0, 0, 0}), E = d.ground_point("E", {4, 0, 0});
  const int B = d.point("B", {0, 1, 0}), C = d.point("C", {2, 2, 0}), D = d.point("D", {4, 1, 0});
  d.bodies({{"crank", {A, B}}, {"left", {B, C}}, {"right", {C, D}}, {"second crank", {E, D}}});
  d.angle("theta", line(A, B)).driven = true;
  d.component("height", B, 1).driven = true;
  expect_refused(d.release_pinned(), {still, still}, {"under-constrained", "'second crank'"});
}

TEST(Refused, DriverThatMeasuresAConstantDistance) {
  // By their number the restrictions suffice; but a crank's length cannot be driven.
  Sketch d = four_bar_sketch();
  d.distance("spoke", 0, 2);  // A-B
  expect_refused(driven(d.release_pinned(), {"spoke"}), {still},
                 {"crank", "'spoke'", "do not determine", "drive other coordinates"});
}

TEST(Refused, LinkThatCannotReach) {
  expect_refused(driven(four_bar_sketch(100).release_pinned(), {"theta"}), turning,
                 {"cannot be assembled", "coupler", "rocker", "(between ", "check the dimensions"});
}

TEST(Refused, DistanceAlongAVectorThatTheBodyLeaves) {
  Sketch d("crank", 2);
  const int A = d.ground_point("A", {0, 0, 0}), B = d.point("B", {1, 0, 0});
  const int x = d.ground_vector("x", {1, 0, 0});
  d.body("crank", {A, B});
  d.angle("theta", line(A, B)).driven = true;
  d.along("s", A, B, x);
  expect_refused(d.release_pinned(), {still}, {"over-constrained", "crank", "'theta'"});
}

TEST(Refused, LineThatIsDrawnOffTheVectorAlongWhichItIs) {
  Sketch d("sleeve", 3);
  const int A = d.ground_point("A", {0, 0, 0}), z = d.ground_vector("z", {0, 0, 1});
  const int P = d.point("P", {0.03, 0, 2}), sleeve = d.body("sleeve", {P}, {z});
  d.joint(JointType::cylindrical, Sketch::ground, sleeve, {A, P}, {z}, "post");
  d.component("height", P, 2).driven = true;
  expect_refused(d.release(), {still},
                 {"joint 'post': A-P is not along 'z' in the nominal position: it is off by 0.03 m",
                  "\"at\""});
}

TEST(Refused, CoordinateThatMeasuresNothingThatMoves) {
  Sketch d = four_bar_sketch();
  d.distance("base", 0, 1);  // A-D
  const Mechanism measured = driven(d.release_pinned(), {"theta"});
  expect_refused(measured, turning, {"'base'", "measures nothing that can move"});
  expect_refused(driven(measured, {"theta", "base"}), {still, still},
                 {"'base'", "measures nothing that can move; drive another"});
}

TEST(Refused, BodyThatCarriesNothing) {
  Sketch d = four_bar_sketch();
  d.body("ghost", {});
  expect_refused(driven(d.release_pinned(), {"theta"}), turning,
                 {"'ghost'", "carries no point", "; list some in it"});
}

TEST(Refused, MechanismWithoutMovingBodies) {
  Sketch d("rock", 2);
  d.ground_point("A", {0, 0, 0});
  expect_refused(d.release(), {}, {"rock", "no body that moves"});
}

TEST(Refused, MotionsThatAreNotOneForEachDriver) {
  expect_refused(driven(four_bar_sketch().release_pinned(), {"theta"}), {},
                 {"linkage", "0 motions for 1 driver"});
}

TEST(Refused, TwoLinksOfDifferentLengthBetweenTheSamePoints) {
  Sketch d = four_bar_sketch(3.0);
  d.link("twin", 2, 3, 3.5);  // B-C, as the coupler
  expect_refused(driven(d.release_pinned(), {"theta"}), turning, {"coupler", "twin"});
}

/// In space an angle takes vectors; a line would be silently misread. With `towards` at 60 degrees
/// from `from` the definition does not measure an angle.
TEST(Refused, SpatialAngleFromASegmentOrBetweenDirectionsThatAreNotNormal) {
  Sketch d("arm", 3);
  const int O = d.ground_point("O", {0, 0, 0}), X = d.ground_point("X", {1, 0, 0}),
            Z = d.ground_point("Z", {0, 0, 1}), P = d.point("P", {1, 0, 1});
  const int y = d.ground_vector("y", {0, 1, 0}), x = d.ground_vector("x", {1, 0, 0}),
            oblique = d.ground_vector("oblique", {0.5, 0, std::sqrt(0.75)});
  d.body("arm", {O, P}, {y});
  d.spatial_angle("phi", line(O, P), x, oblique).driven = true;
  Mechanism mechanism = d.release_pinned({y});
  expect_refused(mechanism, turning, {"'phi'"});
  mechanism.coordinates[0].from = line(O, X);
  mechanism.coordinates[0].towards = line(O, Z);
  expect_refused(mechanism, turning, {"'phi'"});
}

/// A crank and two bodies between its end A and a point B, each with a shape of its own, in the
/// plane. On the ground: A and B rest, and one body hangs on both, with D so far from A.
Mechanism two_shapes(double first, double second, double size, bool on_ground,
                     double neighbour = 1) {
  const auto number = [&](double x) { return formatted("%.17g", x * size); };
  const std::string a = number(1), place = "[" + a + ", 0]", own = "[" + number(second) + ", 0]",
                    place_b = "[" + number(1 + first) + ", 0]", far = number(neighbour);
  const std::string text = on_ground
                               ? R"("points": {"A": )" + place + R"(, "B": )" + place_b + R"(},
        "ground": {"points": ["A", "B"]},
        "bodies": {
          "f": {"at": [)" + a + R"(, 0, 0],
                "points": {"A": [0, 0], "B": )" +
                                     own + R"(, "D": [0, )" + far + R"(]}},
          "g": {"at": [)" + a + ", " +
                                     far + R"(, 0], "points": {"D": [0, 0], "E": [)" + a +
                                     R"(, 0]}}},
        "joints": [{"type": "revolute", "bodies": ["ground", "f"], "points": ["A"]},
                   {"type": "revolute", "bodies": ["ground", "f"], "points": ["B"]},
                   {"type": "revolute", "bodies": ["f", "g"], "points": ["D"]}],
        "coordinates": {"a": {"angle": ["D", "E"]}}})"
                               : R"("points": {"O": [0, 0]}, "ground": {"points": ["O"]},
        "bodies": {"c": {"at": [0, 0, 0], "points": {"O": [0, 0], "A": )" +
                                     place + R"(}},
          "e": {"at": [)" + a + R"(, 0, 0], "points": {"A": [0, 0], "B": [)" +
                                     number(first) +
                                     R"(, 0]}},
          "f": {"at": [)" + a + R"(, 0, 0], "points": {"A": [0, 0], "B": )" +
                                     own + R"(}}},
        "joints": [{"type": "revolute", "bodies": ["ground", "c"], "points": ["O"]},
                   {"type": "revolute", "bodies": ["c", "e"], "points": ["A"]},
                   {"type": "revolute", "bodies": ["e", "f"], "points": ["A"]},
                   {"type": "revolute", "bodies": ["e", "f"], "points": ["B"]}],
        "coordinates": {"a": {"angle": ["O", "A"]}, "b": {"angle": ["A", "B"]}}})";
  return parse_mechanism(R"({"format": "desmo-mechanism", "version": 1, "name": "shapes",
      "dimension": 2, )" + text,
                         "shapes.json");
}

TEST(Refused, TwoShapesThatDiffer) {
  for (const double size : {1e-6, 1.0, 1e5})
    for (const double other : {1.4, 1.01}) {
      expect_refused(driven(two_shapes(1, other, size, false), {"a", "b"}), {still, still},
                     {"A-B length", "shapes"});
      expect_refused(driven(two_shapes(1, other, size, true), {"a"}), {still},
                     {"'f: A-B length'", "contradict"});
    }
  EXPECT_NO_THROW(model_mechanism(driven(two_shapes(0.3, 0.3, 1, true), {"a"}), {still}));
  EXPECT_NO_THROW(
      model_mechanism(driven(two_shapes(0.7, 0.7, 1e-6, false), {"a", "b"}), {still, still}));
}

/// An equation is left out where the digits of a shape explain its misfit: up to 1e-4 of the
/// distance of A and B. The distance of D from them does not matter.
TEST(Refused, ShapesOnTheGroundThatDifferByMoreThanDigitsAndNoOthers) {
  for (const double size : {1e-6, 1.0, 1e5})
    for (const double neighbour : {1., 100.}) {
      const auto shapes = [&](double longer) {
        return driven(two_shapes(1, 1 + longer, size, true, neighbour), {"a"});
      };
      for (const double longer : {0., 1e-11, 1e-6, 9e-5}) {
        const ModellingResult nearly = model_mechanism(shapes(longer), {still});
        EXPECT_EQ(std::ranges::count(nearly.left_out, "f: A-B length", &LeftOut::equation),
                  longer > 0);
        const Model kept = make_plan(nearly.model, {}).model;
        EXPECT_EQ(std::ranges::count(kept.constraints, "f: A-B length", &Constraint::name),
                  longer > 0);
        // A request that needs neither body names the one whose equation is not looked at.
        const Plan other =
            make_plan(nearly.model, std::vector{Output{nearly.model.find("a"), Level::position}});
        EXPECT_EQ(std::ranges::count(other.groups, true, &Plan::GroupUse::may_lock), longer > 0);
      }
      expect_refused(shapes(1.1e-4), {still}, {"'f: A-B length'", "contradict"});
    }
}

}  // namespace
}  // namespace desmo::refusals_test
