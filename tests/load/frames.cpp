// Mechanisms whose bodies are given in frames of their own, roughly drawn, move as they do when
// they are drawn exactly: with automatic and generated equations, and proven.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "cases/io/files.h"
#include "formulations/modelling/bodies/rigid_bodies.h"
#include "formulations/verification/run/checked_run.h"
#include "tests/everything.h"
#include "tests/load/loading.h"
#include "tests/refusal.h"

namespace desmo::load::frames_test {
namespace {

using Eigen::AngleAxisd, Eigen::Vector3d;

Mechanism::Vec plain(const Vector3d& x) { return {x[0], x[1], x[2]}; }

/// Gives each body a frame with its first point as origin, turned by this vector. Its drawing is
/// off by degrees and by per cent of the mechanism's size, otherwise for each body.
Mechanism in_rough_frames(Mechanism mechanism, Vector3d rotation, double size) {
  if (mechanism.dimension == 2) rotation = {0, 0, rotation[2]};
  const Eigen::Matrix3d turn = AngleAxisd(rotation.norm(), rotation.normalized()).matrix();
  for (std::size_t b = 1; b < mechanism.bodies.size(); ++b) {
    Mechanism::Body& body = mechanism.bodies[b];
    const Vector3d origin(mechanism.points[body.points[0]].position.data());
    Vector3d off(std::cos(2.0 * b), std::sin(5.0 * b), std::cos(3.0 * b));
    if (mechanism.dimension == 2) off[2] = 0;
    const double angle = (b % 2 == 0 ? 0.06 : -0.06);
    Mechanism::Frame& own = body.own.emplace();
    own.origin = plain(origin + 0.02 * size * off);
    own.rotation = plain(rotation + angle * (mechanism.dimension == 2 ? Vector3d::UnitZ() : off));
    const auto in_frame = [&](const Vector3d& x) -> Mechanism::ExactVec {
      const Vector3d local = turn.transpose() * x;
      return {local[0], local[1], local[2]};
    };
    for (const int p : body.points)
      own.points.push_back(in_frame(Vector3d(mechanism.points[p].position.data()) - origin));
    for (const int v : body.vectors)
      own.vectors.push_back(in_frame(Vector3d(mechanism.vectors[v].direction.data())));
  }
  return mechanism;
}

/// Returns the text of a mechanism without what only frames need to give.
std::string text_without_drawing(const Mechanism& mechanism) {
  nlohmann::ordered_json text = nlohmann::ordered_json::parse(write_mechanism(mechanism));
  const auto erase = [&](const char* kind, const auto& all, const std::vector<int>& kept) {
    for (int i = 0; i < static_cast<int>(all.size()); ++i)
      if (std::ranges::find(kept, i) == kept.end()) text[kind].erase(all[i].name);
  };
  erase("points", mechanism.points, mechanism.bodies[0].points);
  erase("vectors", mechanism.vectors, mechanism.bodies[0].vectors);
  return text.dump();
}

struct Named {
  const char* scene;
  double size;  // in the mechanism's unit
};

class Frames : public Loading, public testing::WithParamInterface<Named> {};

TEST_P(Frames, RoughlyDrawnMoveAsDrawnExactly) {
  Scene drawn = library_scene(GetParam().scene);
  drawn.grid.instants = std::min(drawn.grid.instants, 101);
  scene_ = drawn;
  const Mechanism rough =
      in_rough_frames(drawn.mechanism, Vector3d(0.7, -0.4, 2.1), GetParam().size);
  scene_.mechanism = parse_mechanism(text_without_drawing(rough), "rough.json");
  model_ = make_model(scene_);
  const Model exact = make_model(drawn);
  KernelTable table;
  const Settings settings{.tolerance = 1e-14};
  const Everything expected =
      everything_of(*formulated("group_automatic_lapack", exact, settings), drawn.grid);
  for (const std::string id : {"global_automatic_klu", "group_automatic_lapack",
                               "global_symbolic_klu", "group_symbolic_inlined"}) {
    const auto f = made(id, table, settings);
    int flagged = 0;
    CheckOptions options;
    options.checked = [&](const CheckedInstant& i) { flagged += i.flag.has_value(); };
    Everything found(drawn.grid.instants);
    ASSERT_TRUE(run_checked(*f, drawn.grid, {}, found, options).ok()) << id;
    EXPECT_EQ(flagged, 0) << id;
    const std::size_t n = static_cast<std::size_t>(model_.coordinates());
    for (const Entity& e : model_.entities) {
      if (e.fixed) continue;
      const Entity& same = exact.entities[exact.find(e.name)];
      for (int i = 0; i < 3 * e.size; ++i) {  // of each level
        const std::size_t at = i / e.size * n + i % e.size;
        double largest = 1, off = 0;
        for (int row = 0; row < drawn.grid.instants; ++row) {
          const double right = expected.all[row][same.first + at];
          largest = std::max(largest, std::abs(right));
          off = larger_error(off, std::abs(found.all[row][e.first + at] - right));
        }
        EXPECT_LE(off, 1e-12 * largest) << id << ": " << e.name << ", " << i;
      }
    }
  }
}

/// H stands off the plane of the axis and C: turned back far enough it is on the other side. Where
/// it stands nearly in that plane, the plane's normal tells the hand.
TEST(FramesInSpace, AreRefusedWhereTheyStandAsInAMirror) {
  const auto flap = [](const std::string& turned, const std::string& off) {
    return parse_mechanism(
        R"({"format": "desmo-mechanism", "version": 1, "name": "flap", "dimension": 3,
      "units": {"angle": "deg"}, "points": {"G": [0, 0, 0]},
      "vectors": {"x": [1, 0, 0], "y": [0, 1, 0], "z": [0, 0, 1]},
      "ground": {"points": ["G"], "vectors": ["x", "y", "z"]},
      "bodies": {"flap": {"at": [0, 0, 0, )" +
            turned + R"(, 0, 0],
        "points": {"G": [0, 0, 0], "C": [60, 0, 0], "H": [30, )" +
            off + R"(, -5]}, "vectors": {"z": [0, 0, 1]}}},
      "joints": [{"type": "revolute", "bodies": ["ground", "flap"], "points": ["G"], "vectors": ["z"]}],
      "coordinates": {"theta": {"angle": ["G", "C"], "from": "x", "towards": "y"}},
      "drivers": ["theta"]})",
        "flap.json");
  };
  EXPECT_NO_THROW(find_rigid_bodies(flap("-63", "10")));
  EXPECT_NO_THROW(find_rigid_bodies(flap("-80", "1")));
  EXPECT_CONTAINS(refusal([&] { find_rigid_bodies(flap("-64", "10")); }), "body 'flap'");
}

INSTANTIATE_TEST_SUITE_P(Library, Frames,
                         testing::Values(Named{"watt_six_bar", 4}, Named{"rssr", 1},
                                         Named{"double_wishbone", 0.4}),
                         [](const auto& info) { return std::string(info.param.scene); });

}  // namespace
}  // namespace desmo::load::frames_test
