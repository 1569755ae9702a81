// Starts many turns from the drawing: whole turns that lead back are left out, others are not.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "formulations/model/scales.h"
#include "formulations/verification/branch/start.h"
#include "tests/accuracy/scenes.h"
#include "tests/certificate/starts.h"
#include "tests/checked/rows.h"

namespace desmo::start_after_turns_test {
namespace {

using Stage = FoundStart::Stage;

/// After 16,667 turns of the crank. Nobody follows them all.
TEST(StartAfterTurns, LeavesOutManyTurns) {
  Model m = make_model(library_scene("slider_crank"));
  m.drivers[0].motion = Polynomial{{0, 10.473}};
  const double time = 1e4;
  const FoundStart found = find_start(m, time);
  EXPECT_EQ(found.stage, Stage::reached);
  EXPECT_EQ(m.value("theta", found.q), 10.473 * time);
  const std::vector<double> right =
      in_short_steps(m, {std::remainder(10.473 * time, whole_turn)}, 0.01);
  EXPECT_LT(std::abs(m.value("s", found.q) - m.value("s", right)), 1e-10 * nominal_size(m));
}

/// Beyond 2⁵³ rad, whole turns left out, a step of a radian is lost in the rounding of the way.
/// No test is spent on it.
TEST(StartAfterTurns, IsNotSoughtWhereStepsAreLostInRounding) {
  const Model m = make_model(library_scene("slider_crank"));
  for (const double to : {1e60, -1e97, 1e300}) {
    const FoundStart found = find_start(held_at(m, {to}), 0);
    EXPECT_EQ(found.stage, Stage::drivers) << to;
    EXPECT_TRUE(found.out_of_tests) << to;
    EXPECT_EQ(found.share, 0) << to;
  }
}

/// A worm turns the crank of a four-bar by 2π/ratio a turn of the fast crank, whose slider takes
/// all tests. What has moved is not back, however little: after 1,500 turns the four-bar is
/// elsewhere.
TEST(StartAfterTurns, LeavesOutNoTurnOfAShaftThatASlowOneFollows) {
  const auto start = [](const std::string& ratio) {
    const Scene scene = parse_scene(R"({"format": "desmo-scene", "version": 2, "mechanism": {
      "format": "desmo-mechanism", "version": 1, "name": "worm", "dimension": 2,
      "points": {"O": [0, 0], "P": [30, 0], "C": [-1, 0], "Q": [100, 0], "R": [115, 25.980762113533157],
        "B": [187.96675386669742, 58.78095769460853], "G": [200, 0]},
      "vectors": {"x": [1, 0]},
      "ground": {"points": ["O", "Q", "G"], "vectors": ["x"]},
      "bodies": {"fast": {"points": ["O", "P"]}, "rod": {"points": ["P", "C"]},
        "slider": {"points": ["C"], "vectors": ["x"]}, "slow": {"points": ["Q", "R"]},
        "coupler": {"points": ["R", "B"]}, "rocker": {"points": ["B", "G"]}},
      "joints": [{"type": "revolute", "bodies": ["ground", "fast"], "points": ["O"]},
        {"type": "revolute", "bodies": ["fast", "rod"], "points": ["P"]},
        {"type": "revolute", "bodies": ["rod", "slider"], "points": ["C"]},
        {"type": "prismatic", "bodies": ["ground", "slider"], "vectors": ["x"], "points": ["O", "C"]},
        {"type": "revolute", "bodies": ["ground", "slow"], "points": ["Q"]},
        {"type": "revolute", "bodies": ["slow", "coupler"], "points": ["R"]},
        {"type": "revolute", "bodies": ["coupler", "rocker"], "points": ["B"]},
        {"type": "revolute", "bodies": ["rocker", "ground"], "points": ["G"]}],
      "coordinates": {"a": {"angle": ["O", "P"]}, "b": {"angle": ["Q", "R"]}},
      "couplings": {"worm": {"sum": {"a": 1, "b": -)" +
                                        ratio + R"(}}}, "drivers": ["a"]},
      "motion": {"a": {"type": "constant", "value": 0}}, "time": {"at": 0}})",
                                    "worm.json", "");
    return find_start(held_at(make_model(scene), {1500 * whole_turn}), 0).stage;
  };
  EXPECT_EQ(start("1"), Stage::reached);
  EXPECT_EQ(start("2000"), Stage::drivers);
  if (DESMO_SANITIZED) return;
  // Ten times max_drift a turn, and a tenth of it, which would have to last for 10⁹ turns.
  EXPECT_EQ(start("6.3e8"), Stage::drivers);
  EXPECT_EQ(start("6.3e10"), Stage::reached);
}

/// A differential: wheel c makes half of the turns that a and b make. Turns of both lead back where
/// they are as many, those of one alone do not.
TEST(StartAfterTurns, LeavesOutTurnsOfSeveralDriversWhereEachLeadsBack) {
  const Scene scene = parse_scene(R"({"format": "desmo-scene", "version": 2, "mechanism": {
      "format": "desmo-mechanism", "version": 1, "name": "differential", "dimension": 2,
      "points": {"O": [0, 0], "A": [1, 0], "P": [3, 0], "B": [4, 0], "Q": [6, 0], "C": [7, 0]},
      "ground": {"points": ["O", "P", "Q"]},
      "bodies": {"first": {"points": ["O", "A"]}, "second": {"points": ["P", "B"]},
        "third": {"points": ["Q", "C"]}},
      "joints": [{"type": "revolute", "bodies": ["ground", "first"], "points": ["O"]},
        {"type": "revolute", "bodies": ["ground", "second"], "points": ["P"]},
        {"type": "revolute", "bodies": ["ground", "third"], "points": ["Q"]}],
      "coordinates": {"a": {"angle": ["O", "A"]}, "b": {"angle": ["P", "B"]},
        "c": {"angle": ["Q", "C"]}},
      "couplings": {"differential": {"sum": {"a": 1, "b": 1, "c": -2}}}, "drivers": ["a", "b"]},
      "motion": {"a": {"type": "constant", "value": 0}, "b": {"type": "constant", "value": 0}},
      "time": {"at": 0}})",
                                  "differential.json", "");
  const Model m = make_model(scene);
  const FoundStart equal =
      find_start(held_at(m, {1e4 * whole_turn + 0.1, 1e4 * whole_turn + 0.3}), 0);
  EXPECT_EQ(equal.stage, Stage::reached);
  EXPECT_NEAR(m.value("c", equal.q), 1e4 * whole_turn + 0.2, 1e-9);
  const FoundStart other = find_start(held_at(m, {1e4 * whole_turn, 10001 * whole_turn}), 0);
  EXPECT_EQ(other.stage, Stage::reached);
  EXPECT_NEAR(m.value("c", other.q), 10000.5 * whole_turn, 1e-9);
  EXPECT_NEAR(m.value("C.x", other.q), 5, 1e-9);
}

/// The linkage locks a third of a turn from where it is drawn. Beyond a whole turn the crank could
/// stand as it does before, but nothing leads there.
TEST(StartAfterTurns, LeavesOutNoTurnThatIsBlocked) {
  const Model m = make_model(scene_file("peaucellier"));
  const double drawn = drawn_drivers(m)[0];
  for (const double to :
       {drawn - whole_turn - 0.1, drawn + whole_turn + 0.1, drawn + 300 * whole_turn + 0.1}) {
    const FoundStart found = find_start(held_at(m, {to}), 0);
    EXPECT_EQ(found.stage, Stage::drivers) << to;
    EXPECT_LT(found.share, 0.6) << to;
  }
}

}  // namespace
}  // namespace desmo::start_after_turns_test
