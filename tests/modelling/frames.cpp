// Bodies in frames of their own: what joints of theirs keep constant, and what is refused.

#include "formulations/modelling/frames/frames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "formulations/modelling/bodies/rigid_bodies.h"
#include "formulations/modelling/equations/candidates.h"
#include "formulations/modelling/groups/structure.h"
#include "tests/modelling/common.h"

namespace desmo::frames_test {
namespace {

/// A ground with joints, each to a body of its own that is drawn where it cannot be meant to be.
Mechanism joined(int dimension) {
  Sketch d("joined", dimension);
  const int O = d.ground_point("O", {0, 0, 0});
  const int u = d.ground_vector("u", dimension == 2 ? Vec{0.6, 0.8, 0} : Vec{0, 0.6, 0.8});
  const auto add = [&](JointType type, const std::string& name, bool has_vector) {
    const int P = d.point("P " + name, {1, 0.3, 0});
    const int b = d.body(name, {P}, has_vector ? std::vector{u} : std::vector<int>{});
    d.joint(type, Sketch::ground, b, {O, P}, {u});
  };
  if (dimension == 2) {
    add(JointType::prismatic, "slider", true);
    add(JointType::revolute_on_slider, "pin", false);
    return d.release();
  }
  add(JointType::planar, "plate", true);
  add(JointType::point_on_plane, "tip", false);
  const int w = d.vector("w", {0, 0.8, 0.6});
  d.joint(JointType::universal, Sketch::ground, d.body("shaft", {O}, {w}), {O}, {u, w});
  return d.release();
}

Mechanism with_frames(Mechanism mechanism) {
  for (std::size_t b = 1; b < mechanism.bodies.size(); ++b) {
    Mechanism::Frame& own = mechanism.bodies[b].own.emplace();
    own.points.resize(mechanism.bodies[b].points.size(), Mechanism::ExactVec{2., 1., 0.});
    own.vectors.resize(mechanism.bodies[b].vectors.size(), {Derived(1), Derived(0), Derived(0)});
  }
  return mechanism;
}

TEST(Frame, LetsJointsKeepNothingOfTheDrawing) {
  for (const int dimension : {2, 3})
    for (const bool has_frames : {false, true}) {
      Mechanism mechanism = joined(dimension);
      if (has_frames) mechanism = with_frames(mechanism);
      const RigidBodies rigid = find_rigid_bodies(mechanism);
      const Structure together = dimension == 2 ? Structure{{{{1, 2}, {}}}, {-1, 0, 0}}
                                                : Structure{{{{1, 2, 3}, {}}}, {-1, 0, 0, 0}};
      const Model all = make_candidate_equations(mechanism, rigid, together, {});
      int found = 0;
      for (const Constraint& c : all.constraints)
        if (c.source == EquationSource::joint) {
          ++found;
          EXPECT_EQ(c.constants[0].value == 0, has_frames) << c.name;
        }
      EXPECT_EQ(found, dimension);
    }
}

TEST(Frame, ThatIsNotWholeIsRefused) {
  const auto refused = [](auto&& change, const std::string& what) {
    Mechanism mechanism = with_frames(joined(2));
    change(mechanism, *mechanism.bodies[1].own);
    expect_refused(mechanism, {}, {what});
  };
  using Frame = Mechanism::Frame;
  refused([](Mechanism&, Frame& f) { f.points.clear(); }, "'slider': has a frame of its own; give");
  refused([](Mechanism&, Frame& f) { f.vectors[0][1] = 1e-4; }, "not of length 1");
  refused([](Mechanism&, Frame& f) { f.rotation[2] = NAN; }, "has a frame with a number that is");
  refused([](Mechanism&, Frame& f) { f.points[0][2] = 1; }, "or, in the plane, a third component");
  refused([](Mechanism& mechanism, Frame& f) { mechanism.bodies[0].own = f; },
          "is the ground, or has a length");
  refused(
      [](Mechanism& mechanism, Frame&) {
        mechanism.joints[0] = {"weld", JointType::fixed, {0, 1}, {}, {}};
      },
      "joint 'weld': fixes 'slider', which has a frame of its own");
}

/// Far from the origin, where a drawing has fewer digits.
TEST(Frame, KeepsWhatIsSmallInIt) {
  Sketch d("far", 2);
  const int O = d.ground_point("O", {1e7, 0, 0});
  const int A = d.point("A", {1e7 + 1, 0, 0}), P = d.point("P", {1e7, 0.3, 0});
  const int arm = d.body("arm", {O, A, P});
  d.joint(JointType::revolute, Sketch::ground, arm, {O});
  d.angle("theta", line(O, A)).driven = true;
  Mechanism m = d.release();
  m.bodies[arm].own.emplace().points = {{0, 0, 0}, {1, 0, 0}, {0.25, 1e-9, 0}};
  const Model model = model_mechanism(m, turning).model;
  const auto relation = std::ranges::find(model.constraints, "arm: P rigid", &Constraint::name);
  ASSERT_NE(relation, model.constraints.end());
  EXPECT_EQ(values_of(*relation), (std::vector<double>{0.25, 1e-9}));
}

/// A drawing is rough: directions that are perpendicular on a body need not be so in it.
TEST(Frame, TellsWhetherDirectionsOfAnAngleArePerpendicular) {
  Sketch d("carrier", 3);
  const int O = d.ground_point("O", {0, 0, 0}), z = d.ground_vector("z", {0, 0, 1});
  const int x = d.vector("x", {0.8, 0, 0.6}), P = d.point("P", {1, 1, 0});
  const int body = d.body("body", {O}, {z, x});
  d.joint(JointType::revolute, Sketch::ground, body, {O}, {z});
  d.joint(JointType::spherical, body, d.body("arm", {O, P}), {O}, {});
  d.spatial_angle("a", line(O, P), z, x);
  Mechanism m = d.release();
  using Direction = std::array<Derived, 3>;
  Mechanism::Frame& own = m.bodies[body].own.emplace();
  own.points = {{}};
  own.vectors = {Direction{0.0, 0.0, 1.0}, Direction{1.0, 0.0, 0.0}};
  EXPECT_NO_THROW(validate(m));
  own.vectors[1] = {0.6, 0.0, 0.8};
  expect_refused(m, {}, {"'a'", "are not at a right angle"});
}

/// Two bodies share two vectors: the second one leaves no turn about the first, unless both are the
/// same but for what is no angle.
TEST(Frame, IsTurnedBySharedVectorsThatAreApart) {
  for (const double share : {1. / 3, 3.}) {
    const double angle = share * 1e-6;
    Sketch d("shared", 3);
    d.ground_point("O", {0, 0, 0});
    const int P = d.point("P", {1, 0, 0});
    const int u = d.vector("u", {0, 0, 1}),
              v = d.vector("v", {std::sin(angle), 0, std::cos(angle)});
    const int Q = d.point("Q", {2, 0, 0}), R = d.point("R", {2, 3, 0}), S = d.point("S", {3, 1, 0}),
              T = d.point("T", {3, 1, 2});
    const int a = d.body("a", {P, Q, R}, {u, v}), b = d.body("b", {P, S, T}, {u, v});
    d.joint(JointType::revolute, a, b, {P}, {u});
    const Mechanism mechanism = d.release();
    const Structure together{{{{1, 2}, {}}}, {-1, 0, 0}};
    const FramedMechanism framed =
        put_frames(mechanism, find_rigid_bodies(mechanism), together, Modelling::reference);
    EXPECT_EQ(framed.vectors.size(), share < 1 ? 2u : 3u);
  }
}

}  // namespace
}  // namespace desmo::frames_test
