// desmo list, show and inspect.

#include <algorithm>
#include <filesystem>

#include "cases/library/library.h"
#include "tests/cli/program.h"
#include "tests/flaps.h"

namespace desmo::inspecting_test {
namespace {

namespace fs = std::filesystem;

TEST_F(Cli, ListsWhatThereIs) {
  ASSERT_EQ(desmo("list"), 0) << err_;
  ASSERT_FALSE(library().empty());
  for (const LibraryMechanism& m : library()) EXPECT_TRUE(prints("  " + std::string(m.name) + " "));
  EXPECT_TRUE(prints("truck_suspension"));
  EXPECT_TRUE(prints("block_symbolic_inlined"));

  const Json all = json_of("list --json");
  EXPECT_EQ(all["mechanisms"].size(), library().size());
  EXPECT_EQ(all["cases"].size(), 2u);
  EXPECT_GT(all["formulations"].size(), 10u);
  const auto crank = std::ranges::find_if(
      all["mechanisms"], [](const Json& m) { return m["name"] == "slider_crank"; });
  ASSERT_NE(crank, all["mechanisms"].end());
  EXPECT_EQ((*crank)["bodies"], 3);
  EXPECT_EQ((*crank)["degrees_of_freedom"], 1);
  EXPECT_EQ((*crank)["dimension"], 2);

  expect_printed("list cases", "four_bar");
  EXPECT_FALSE(prints("slider_crank"));
  EXPECT_EQ(desmo("list dogs"), 64);
}

TEST_F(Cli, ShowsCouplingsInTheirGroups) {
  const std::string scene = "'" DESMO_SOURCE_DIR "/tests/load/scenes/planetary_gear.scene.json'";
  expect_printed("inspect " + scene, "couplings     inner_mesh, outer_mesh");
  const Json groups = json_of("inspect --json " + scene)["groups"];
  EXPECT_EQ(groups[0]["couplings"], Json::array());
  EXPECT_EQ(groups[1]["couplings"], Json({"inner_mesh", "outer_mesh"}));
}

TEST_F(Cli, ShowsWhatIsThenReadBack) {
  for (const LibraryMechanism& m : library()) {
    const std::string name(m.name);
    ASSERT_EQ(desmo("show " + name + " >mechanism.json"), 0);
    ASSERT_EQ(desmo("show " + name + " --scene >scene.json"), 0);
    EXPECT_EQ(text_of(folder_ / "mechanism.json"), m.mechanism);
    const std::string from_mechanism = printed("inspect mechanism.json");
    EXPECT_EQ(printed("inspect scene.json"), from_mechanism);
    EXPECT_EQ(printed("inspect - <scene.json"), from_mechanism);
    EXPECT_EQ(printed("inspect " + name), from_mechanism);
  }
}

TEST_F(Cli, InspectsTheStructureOfTheTruck) {
  expect_printed("inspect truck_suspension:1",
                 "114 coordinates: 112 dependent, 2 independent (axle1/zL, axle1/zR)",
                 "axle1/SG-I (4, 2)\n    bodies        axle1/2, axle1/3, axle1/4, axle1/5\n",
                 "axle1/SG-II (2, 0)", "axle1/SG-V (2, 0)", "bodies        axle1/12, axle1/13",
                 "16 + 6×3 + 5×1", "Constant parts, solved once: 1", "12 moving bodies, 18 joints");

  const Json all = json_of("inspect truck_suspension:2 --json");
  EXPECT_EQ(all["coordinates"]["all"], 2 * 111 + 3);
  EXPECT_EQ(all["coordinates"]["independent"].size(), 4u);
  EXPECT_EQ(all["constant_parts"], 1);
  EXPECT_EQ(all["groups"].size(), 11u);
  for (const Json& group : all["groups"]) {
    std::size_t unknowns = 0, equations = 0;
    for (const Json& block : group["blocks"]) {
      unknowns += block["unknowns"].size();
      for (const Json& equation : block["equations"]) equations += equation["rows"].size();
    }
    EXPECT_EQ(unknowns, group["unknowns"]);
    EXPECT_EQ(equations, unknowns);
  }
  EXPECT_EQ(all["groups"][2]["after"], Json{"axle1/SG-I"});
  EXPECT_EQ(all["groups"][2]["on_ground"], true);
}

TEST_F(Cli, InspectsTheTreeOfTheTruck) {
  expect_printed("inspect truck_suspension:1 --coordinates relative", "relative coordinates\n",
                 "solves for    axle1/phi6, ",
                 "Spanning tree, parents first:", "axle1/2 on axle1/3: ", "axle1/8 on axle1/6: ",
                 "axle1/11 on axle1/10: ", "Joints that are not of the tree: 6");

  const Json all = json_of("inspect truck_suspension:1 --coordinates reference --json");
  EXPECT_EQ(all["coordinates"]["kind"], "reference");
  EXPECT_EQ(all["tree"].size(), 12u);
  for (const Json& body : all["tree"]) EXPECT_EQ(body["joint"], "");
  EXPECT_EQ(all["cut_joints"].size(), 18u);

  EXPECT_EQ(desmo("inspect truck_suspension:1 --coordinates relativ"), 64);
  expect_said(64, "solve four_bar:1 --formulation group_automatic_klu/coordinates:relative",
              "only natural coordinates are solved here");
}

TEST_F(Cli, MarksRedundantConstraints) {
  const std::string scene = "'" DESMO_SOURCE_DIR "/tests/fuzz/corpus/redundant.json'";
  expect_printed("inspect " + scene, "; redundant but\n", "  consistent: accepted\n");
  const Json left_out = json_of("inspect --json " + scene)["left_out"];
  EXPECT_TRUE(std::ranges::any_of(left_out, [](const Json& l) { return l["redundant"] == true; }));
}

TEST_F(Cli, SaysByHowMuchAShapeDoesNotFitTheGround) {
  write("flap.json", flaps(1, 4e-7));
  expect_printed("inspect flap.json",
                 "flap1: H-K length (SG-I): between points of the ground; off "
                 "by 4.0e-07 m");
  const Json left_out = json_of("inspect flap.json --json")["left_out"];
  EXPECT_FALSE(left_out.empty());
  for (const Json& l : left_out)
    EXPECT_EQ(l["misfit"].is_null(), l["equation"] != "flap1: H-K length") << l;
}

/// A pin in a slot, with a cam on its arm; and two slides of which one rests on the other.
TEST_F(Cli, NotesWhatADrawingMayNotHaveMeant) {
  const auto inspect = [&](const std::string& pin, const std::string& follower) {
    write("m.json", R"({"format": "desmo-mechanism", "version": 1, "name": "slot", "dimension": 2,
      "units": {"length": "mm", "angle": "deg"}, "points": {"A": [0, 0], "H": [10, 0],
        "P": [30, )" + pin +
                        R"(], "F": [0, )" + follower + R"(]},
      "vectors": {"slot": [1, 0], "y": [0, 1]}, "ground": {"points": ["A", "H"], "vectors": ["y"]},
      "bodies": {"arm": {"points": ["A", "P"]}, "gate": {"points": ["H"], "vectors": ["slot"]},
                 "follower": {"points": ["F"], "vectors": ["y"]}},
      "joints": [
        {"type": "revolute", "bodies": ["ground", "arm"], "points": ["A"]},
        {"type": "revolute", "bodies": ["ground", "gate"], "points": ["H"]},
        {"name": "pin", "type": "revolute_on_slider", "bodies": ["gate", "arm"],
         "vectors": ["slot"], "points": ["H", "P"]},
        {"type": "prismatic", "bodies": ["ground", "follower"], "vectors": ["y"],
         "points": ["A", "F"]}],
      "coordinates": {"phi": {"angle": ["A", "P"]}, "s": {"distance": ["A", "F"], "along": "y"}},
      "couplings": {"cam": {"coordinate": "s", "of": "phi", "at": [-180, 180],
                            "values": [40, 40]}},
      "drivers": ["phi"]})");
    ASSERT_EQ(desmo("inspect m.json"), 0) << err_;
  };
  // Of lengths of 20 to 32 mm, 1e-9 is between 1e-8 mm and 1e-7 mm; of 40 mm, 1e-6 is 4e-5 mm.
  inspect("1e-8", "40.00001");
  EXPECT_EQ(err_, "");
  inspect("1e-7", "40.0001");
  EXPECT_TRUE(says("note: pin: ") && says("note: coupling 'cam': ")) << err_;
  inspect("4", "35");
  EXPECT_EQ(err_,
            "note: pin: P is drawn 4 mm off the line through H along 'slot', and stays there\n"
            "note: coupling 'cam': its table gives s = 40 mm where phi is drawn, s is drawn "
            "at 35 mm; where the table is a lift, add \"from\": \"drawing\"\n");

  write("rest.json", R"({"format": "desmo-scene", "version": 2, "mechanism": {
    "format": "desmo-mechanism", "version": 1, "name": "rest", "dimension": 3,
    "points": {"A": [0, 0, 0], "M": [5, 0, 0], "Q": [0, 0, 1], "P": [5, 0, 1.25]},
    "vectors": {"x": [1, 0, 0], "z": [0, 0, 1]},
    "ground": {"points": ["A", "M"], "vectors": ["x", "z"]},
    "bodies": {"table": {"points": ["Q"], "vectors": ["x", "z"]},
               "tip": {"points": ["P"], "vectors": ["x", "z"]}},
    "joints": [
      {"type": "prismatic", "bodies": ["ground", "table"], "vectors": ["z", "x"],
       "points": ["A", "Q"]},
      {"type": "prismatic", "bodies": ["ground", "tip"], "vectors": ["z", "x"],
       "points": ["M", "P"]},
      {"name": "rest", "type": "point_on_plane", "bodies": ["table", "tip"], "vectors": ["z"],
       "points": ["Q", "P"]}],
    "coordinates": {"s": {"distance": ["A", "Q"], "along": "z"}}, "drivers": ["s"]},
    "motion": {"s": {"type": "speed", "value": 1}}, "time": {"at": 0.5}})");
  expect_said(0, "solve rest.json",
              "note: rest: P is drawn 0.25 m off the plane through Q with the normal 'z', and "
              "stays there\n");
  ASSERT_EQ(desmo("solve rest.json --quiet"), 0);
  EXPECT_EQ(err_, "");
}

TEST_F(Cli, NamesIdleFreedoms) {
  expect_printed("inspect rssr", "coupler: free to spin about the line of 'A' and 'B'");
  EXPECT_EQ(json_of("inspect rssr --json")["idle_freedoms"],
            Json::parse(R"([{"body": "coupler", "about": "the line of 'A' and 'B'"}])"));
  ASSERT_EQ(desmo("inspect slider_crank"), 0);
  EXPECT_FALSE(prints("Idle freedoms")) << out_;
}

}  // namespace
}  // namespace desmo::inspecting_test
