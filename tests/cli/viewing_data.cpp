// desmo view: what the scripts of the page read from its data.

#include "tests/cli/view.h"

namespace desmo::viewing_data_test {
namespace {

/// Returns a scene of a second in the plane. mechanism: members of the mechanism; driven: the
/// coordinate that is driven from 0.5 at 1/s, if any.
std::string scene(const std::string& mechanism, const std::string& driven) {
  const std::string motion =
      driven.empty() ? "" : '"' + driven + R"(": {"type": "polynomial", "coefficients": [0.5, 1]})";
  return R"({"format": "desmo-scene", "version": 2, "mechanism": {"format": "desmo-mechanism",
    "version": 1, "name": "m", "dimension": 2, )" +
         mechanism + "}, \"motion\": {" + motion + R"(}, "time": {"end": 1, "step": 0.1}})";
}

TEST_F(View, ReadsAMechanismWithoutDrivers) {
  write("triangle.json", scene(R"(
    "points": {"A": [0, 0], "B": [1, 0], "C": [0.5, 1]}, "ground": {"points": ["A", "B"]},
    "bodies": {"a": {"points": ["A", "C"]}, "b": {"points": ["B", "C"]}},
    "joints": [{"type": "revolute", "bodies": ["ground", "a"], "points": ["A"]},
               {"type": "revolute", "bodies": ["ground", "b"], "points": ["B"]},
               {"type": "revolute", "bodies": ["a", "b"], "points": ["C"]}])",
                               ""));
  expect_on_page_of("triangle.json",
                    "console.log(JSON.stringify([data.drivers, data.driven, data.high]));\n",
                    "[[],[],[1,1,0]]\n");
}

TEST_F(View, ReadsAMechanismWithoutPoints) {
  write("turning.json", scene(R"(
    "points": {}, "vectors": {"u": [0.8, 0.6]}, "ground": {}, "bodies": {"b": {"vectors": ["u"]}},
    "joints": [], "coordinates": {"a": {"angle": "u"}}, "drivers": ["a"])",
                              "a"));
  expect_on_page_of(
      "turning.json",
      "console.log(JSON.stringify([data.points, data.low, data.high, data.size, draw(data)]));\n",
      "[[],[0,0,0],[0,0,0],1,[]]\n");
}

/// A bar that turns about the ground. One of its coordinates has the name of a component of its
/// tip: they cannot both be plotted, and the page draws the tip in any case.
TEST_F(View, TellsColumnsOfTheSameNameApart) {
  const std::string bar = scene(R"(
    "points": {"O": [0, 0], "T": [0.8, 0.6]}, "ground": {"points": ["O"]},
    "bodies": {"bar": {"points": ["O", "T"]}},
    "joints": [{"type": "revolute", "bodies": ["ground", "bar"], "points": ["O"]}],
    "coordinates": {"theta": {"angle": ["O", "T"]}, "T.x": {"component": "T", "axis": "y"}},
    "drivers": ["theta"])",
                                "theta");
  write("bar.json", bar);
  expect_said(65, "view bar.json -o out/page.html",
              "desmo: bar.json: two columns are headed 'T.x [m]', those of coordinate 'T.x' and "
              "point 'T'");
  const std::string time = R"("time": {)";
  write("bar.json", replaced(bar, time, R"("request": [{"angles": ["theta"], "distances": ["T.x"],
    "level": "velocity"}], )" + time));
  expect_on_page_of(
      "bar.json",
      "const plotted = data.plotted.map(c => data.columns[c]);\n"
      "const rate = of => plotted.find(c => c.level === 1 && c.quantity === of.quantity);\n"
      "for (const c of plotted.filter(({level}) => level === 0))\n"
      "  console.log(c.name, ...[c, rate(c)].map(({values}) => values[0].toFixed(3)));\n",
      "theta 0.500 1.000\nT.x 0.479 0.878\n");
}

TEST_F(View, DrawsTheDrivenAngleOfAVectorThatNoJointHas) {
  const std::string bar = R"("points": {"O": [0, 0]}, "ground": {"points": ["O"]},
    "joints": [{"type": "revolute", "bodies": ["ground", "bar"], "points": ["O"]}],
    "coordinates": {"a": {"angle": "u"}}, "drivers": ["a"], )";
  write("drawn.json", scene(bar + R"("vectors": {"u": [0.8, 0.6]},
    "bodies": {"bar": {"points": ["O"], "vectors": ["u"]}})",
                            "a"));
  write("framed.json", scene(bar + R"(
    "bodies": {"bar": {"at": [0, 0, 0.5], "points": {"O": [0, 0]}, "vectors": {"u": [1, 0]}}})",
                             "a"));
  for (const char* file : {"drawn.json", "framed.json"})
    expect_on_page_of(
        file,
        "const drawn = draw(data).filter(({layer}) => layer === layers.drivers);\n"
        "console.log(drawn.map(({at}) => at.map(p => data.points[p].name).join()).join('; '));\n",
        "O\n");
}

/// A joint has its rail on the first body if that alone has the axis, and none if points keep in a
/// plane.
TEST_F(View, DrawsRailsByTheFormsOfJoints) {
  const std::string rails =
      "const rails = draw(data).filter(({layer, at}) => layer === layers.rails && at.length < 2);\n"
      "console.log(rails.map(({body}) => data.bodies[body].name).sort().join(' '));\n";
  write("puck.json", R"({"format": "desmo-scene", "version": 2, "mechanism": {
    "format": "desmo-mechanism", "version": 1, "name": "puck", "dimension": 3,
    "points": {"O": [0, 0, 0], "A": [1, 0, 0]},
    "vectors": {"x": [1, 0, 0], "y": [0, 1, 0], "z": [0, 0, 1], "u": [1, 0, 0]},
    "ground": {"points": ["O"], "vectors": ["x", "y", "z"]},
    "bodies": {"puck": {"points": ["A"], "vectors": ["z", "u"]}},
    "joints": [{"type": "planar", "bodies": ["ground", "puck"], "vectors": ["z"],
                "points": ["O", "A"]}],
    "coordinates": {"a": {"component": "A", "axis": "x"}, "b": {"component": "A", "axis": "y"},
                    "c": {"angle": "u", "from": "x", "towards": "y"}},
    "drivers": ["a", "b", "c"]},
    "motion": {"a": {"type": "polynomial", "coefficients": [1, 1]},
               "b": {"type": "constant", "value": 0}, "c": {"type": "constant", "value": 0.1}},
    "time": {"end": 1, "step": 0.1}})");
  expect_on_page_of("puck.json", rails, "\n");
  expect_on_page_of("whitworth", rails, "ground ground ground lever\n");
}

TEST_F(View, NamesTheCouplerOfATransmissionAngle) {
  expect_on_page_of(
      DESMO_SOURCE_DIR "/tests/range/scenes/quartered_rods.json",
      "console.log(data.transmission.map(c => data.columns[c].name).sort().join('; '));\n",
      "p1 → belt → p2; p1 → belt2 → p2\n");
}

/// Its group QA, QB is drawn singular: no instant is proven.
TEST_F(View, HasNoRadiusWhereNoneIsProven) {
  expect_on_page_of(DESMO_SOURCE_DIR "/tests/checked/scenes/peaucellier.json",
                    "const all = [data.condition, ...data.radii].map(c => [...new "
                    "Set(data.columns[c].values)]);\n"
                    "console.log(data.time.solved > 0, all.join(' '));\n",
                    "true Infinity NaN NaN NaN\n");
}

}  // namespace
}  // namespace desmo::viewing_data_test
