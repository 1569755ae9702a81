// Scene files: what is read, and where the mechanism comes from.

#include <gtest/gtest.h>

#include <numbers>

#include "cases/generators/cases.h"
#include "cases/library/library.h"
#include "tests/files/common.h"
#include "tests/started.h"

namespace desmo::scene_file_test {
namespace {

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
  EXPECT_DOUBLE_EQ(theta.mean.value, std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(theta.terms[0].amplitude.value, std::numbers::pi);
  EXPECT_DOUBLE_EQ(theta.terms[0].angular_frequency.value, 4 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(theta.terms[0].phase.value, std::numbers::pi / 4);
  EXPECT_EQ(theta.terms[1].phase.value, 0);
  EXPECT_NEAR(sample(s.motions[1], 2.0).position, 0.3, 1e-15);
}

const Polynomial& turn(const Scene& scene) { return std::get<Polynomial>(scene.motions[0]); }

TEST(SceneFile, HasTheMechanismsUnitsWhereItSaysNone) {
  constexpr double degree = std::numbers::pi / 180;
  EXPECT_EQ(turn(parse_scene(scene_of(slider_crank, driven), "", "")).coefficients[1].value,
            360 * degree);
  const std::string radians = driven + R"(, "units": {"angle": "rad"})";
  EXPECT_EQ(turn(parse_scene(scene_of(slider_crank, radians), "", "")).coefficients[1].value, 360);
  const std::string of_library = scene_of(R"({"library": "whitworth"})", motion);
  EXPECT_EQ(turn(parse_scene(of_library, "", "")).coefficients[1].value, 360 * degree);
  const std::string no_units =
      replaced(slider_crank, R"("units": {"length": "mm", "angle": "deg"},)", "");
  EXPECT_EQ(turn(parse_scene(scene_of(no_units, driven), "", "")).coefficients[1].value, 360);
  // A scene that names one unit has the mechanism's for the other.
  const std::string both = replaced(slider_crank, "[\"theta\"]", "[\"s\", \"theta\"]");
  const Scene s = parse_scene(scene_of(both, R"("units": {"angle": "rad"}, "motion": {
      "s": {"type": "constant", "value": 200}, "theta": {"type": "constant", "value": 1}})" +
                                                 (", " + time_of_one_second)),
                              "", "");
  EXPECT_EQ(turn(s).coefficients[0].value, 1);
  EXPECT_DOUBLE_EQ(std::get<Polynomial>(s.motions[1]).coefficients[0].value, 0.2);
}

std::string of_version_1(const std::string& scene) {
  return replaced(scene, "\"version\": 2", "\"version\": 1");
}

/// Version 1 took metres and radians; where the mechanism has others, nobody meant that.
TEST(SceneFile, OfVersion1SaysTheUnitsThatItNeeds) {
  const std::string good = scene_of(slider_crank, driven);
  const std::string remedy =
      " the mechanism has its angles in 'deg', and the scene does not say in what this is; give "
      "\"version\": 2, in which the mechanism's units hold, or \"units\": {\"angle\": \"deg\"}";
  EXPECT_EQ(scene_complaint(of_version_1(good)), "s.json: /motion/theta:" + remedy);
  for (const char* units : {R"("units": {})", R"("units": {"length": "mm"})"})
    EXPECT_EQ(scene_complaint(of_version_1(scene_of(slider_crank, driven + ", " + units))),
              "s.json: /motion/theta:" + remedy);
  const std::string angles = driven + R"(, "units": {"angle": "deg"})";
  EXPECT_EQ(
      turn(parse_scene(of_version_1(scene_of(slider_crank, angles)), "", "")).coefficients[1].value,
      360 * std::numbers::pi / 180);
  const std::string defines = R"(, "request": [{"points": {"CG": {"body": "rod", "at": [1, 2]}}}])";
  expect_start(scene_complaint(of_version_1(scene_of(slider_crank, angles + defines))),
               "s.json: /request/0/points/CG: the scene does not say in what unit this is");
  expect_start(scene_complaint(of_version_1(scene_of(R"({"library": "slider_crank"})", motion))),
               "s.json: /motion/theta: the mechanism has its angles in 'deg'");
  EXPECT_EQ(scene_complaint(of_version_1(scene_of(R"({"library": "slider_crank"})", ""))),
            "accepted")
      << "it brings its own motion";
  EXPECT_EQ(scene_complaint(of_version_1(scene_of(R"({"library": "rssr"})", motion))), "accepted")
      << "its mechanism is in metres and radians";

  const std::string slides = replaced(slider_crank, "[\"theta\"]", "[\"s\"]");
  const auto sliding = [&](const std::string& term, const std::string& units) {
    return of_version_1(scene_of(
        slides, units + R"("motion": {"s": {"type": "harmonic", "terms": [{"amplitude": 1, )" +
                    term + "}]}}, " + time_of_one_second));
  };
  expect_start(scene_complaint(sliding(R"("frequency": 1)", "")),
               "s.json: /motion/s: the mechanism has its lengths in 'mm'");
  const std::string millimetres = R"("units": {"length": "mm"}, )";
  EXPECT_EQ(scene_complaint(sliding(R"("frequency": 1)", millimetres)), "accepted");
  expect_start(scene_complaint(sliding(R"("frequency": 1, "phase": 90)", millimetres)),
               "s.json: /motion/s/terms/0/phase: the mechanism has its angles in 'deg'");
}

TEST(SceneFile, MayNameItsSchema) {
  const std::string schema = R"({"$schema": "cases/scene.schema.json", "format")";
  const std::string named = replaced(slider_crank, "{\n  \"format\"", schema);
  EXPECT_EQ(mechanism_complaint(named), "accepted");
  EXPECT_EQ(scene_complaint(replaced(scene_of(named, driven), "{\"format\"", schema)), "accepted");
  expect_start(mechanism_complaint(replaced(named, "\"cases/scene.schema.json\"", "7")),
               "m.json: /$schema: is a number");
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
    EXPECT_EQ(s.mechanism.bodies.size(), c.with_units(3).mechanism.bodies.size());
    EXPECT_EQ(s.motions.size(), c.with_units(3).motions.size());
    EXPECT_EQ(s.grid.instants, 3);
  }
}

using SceneInFolder = InFolder;

TEST_F(SceneInFolder, FindsItsMechanismBesideIt) {
  write("m.json", slider_crank);
  write("bad.json", replaced(slider_crank, "[50, 0]", "[50]"));
  const auto complaint_of = [](const std::string& scene) {
    return refusal<InputError>([&] { read_scene(scene); });
  };
  const std::string good = write("good.scene.json", scene_of("\"m.json\"", driven)),
                    bad = write("bad.scene.json", scene_of("\"bad.json\"", driven)),
                    lost = write("lost.scene.json", scene_of("\"lost.json\"", driven));
  EXPECT_EQ(read_scene(good).mechanism.name, "slider_crank");
  expect_start(complaint_of(bad), file("bad.json") + ": /points/B: wrong dimension");
  expect_start(complaint_of(lost), lost + ": /mechanism: the mechanism file '" + file("lost.json") +
                                       "': there is no such file; ");
  expect_start(scene_complaint(scene_of(R"("a\u0000b")", driven)),
               "s.json: /mechanism: 'a\\u0000b'");
}

/// Names with the level, in the order of the request.
std::vector<std::string> requested(const std::string& request) {
  const Scene s = parse_scene(scene_of(slider_crank, driven + ", \"request\": " + request), "", "");
  std::vector<std::string> names;
  for (const RequestedEntity& w : s.request) {
    const Mechanism& mechanism = s.mechanism;
    names.push_back((w.kind == RequestedEntity::Kind::point ? mechanism.points[w.index].name
                     : w.kind == RequestedEntity::Kind::vector
                         ? mechanism.vectors[w.index].name
                         : mechanism.coordinates[w.index].name) +
                    " " + std::to_string(static_cast<int>(w.level)));
  }
  for (const RequestedMeasure& m : s.measures)
    names.push_back((m.kind == RequestedMeasure::Kind::rotation ? s.mechanism.bodies[m.index].name
                     : m.kind == RequestedMeasure::Kind::joint  ? s.mechanism.joints[m.index].name
                                                                : m.name) +
                    " " + std::to_string(static_cast<int>(m.level)));
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
  // A definition may measure what another one defines, and its name may be asked for again.
  EXPECT_EQ(requested(R"([{"angles": {"mu": {"angle": ["A", "CG"]}}, "level": "velocity"},
                          {"points": {"CG": {"body": "crank", "at": [20, 5]}}},
                          {"points": ["C*"], "rotations": ["r*"], "level": "acceleration"},
                          {"rotations": ["*"], "joints": ["J1"], "ratios": {"i": ["s", "C.x"]}}])"),
            (Names{"mu 1", "CG 2", "C 2", "rod 2", "crank 0", "slider 0", "J1 0", "i 1"}));
}

TEST(SceneFile, WhatNoBodyCarriesCannotBeAskedFor) {
  const std::string more = replaced(slider_crank, "\"A\": [0, 0]", "\"A\": [0, 0], \"O\": [9, 9]");
  const std::string ask = driven + R"(, "request": [{"points": [")";
  EXPECT_EQ(parse_scene(scene_of(more, ask + R"(*"]}])"), "", "").request.size(), 3u);
  expect_start(scene_complaint(scene_of(more, ask + R"(O"]}])")),
               "s.json: /request/0/points/0: 'O' is carried by no body and has no motion; ");
}

}  // namespace
}  // namespace desmo::scene_file_test
