// Dead points at which several loops lock at once, and what does not lock together.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "cases/io/files.h"
#include "cases/mechanism/builder.h"
#include "formulations/modelling/modelling.h"
#include "tests/mechanisms.h"
#include "tests/range/solved_start.h"

namespace desmo::joint_lock_test {
namespace {

using Names = std::set<std::string>;

Names moving(const Model& m, const RangeEnd& end) {
  Names names;
  for (const EntityId e : end.moving) names.insert(m.entities[e].name);
  return names;
}

bool is_held_by(const Model& m, const RangeEnd& end, const std::string& constraint) {
  return std::ranges::any_of(end.constraints,
                             [&](int c) { return m.constraints[c].name == constraint; });
}

/// The platform of a delta robot, driven along its axis z: all three arms come into line with their
/// rods at once. Pivots are 0.15 m further out than the platform; arms have 0.3 m, rods 0.6 m.
class DeltaPlatform : public testing::Test {
 protected:
  const Model m_ =
      make_model(read_scene(DESMO_SOURCE_DIR "/tests/range/scenes/delta_platform_driven.json"));
};

TEST_F(DeltaPlatform, LocksInAllArmsAlongItsAxis) {
  const DriverRange r = range_of(m_, 2);
  EXPECT_NEAR(r.down.value, -std::sqrt(0.9 * 0.9 - 0.15 * 0.15), 1e-14);
  EXPECT_NEAR(r.up.value, -std::sqrt(0.3 * 0.3 - 0.15 * 0.15), 1e-14);
  for (const auto& [end, direction] : {std::pair(&r.down, -1), std::pair(&r.up, 1)}) {
    ASSERT_EQ(end->stop, RangeStop::dead_point);
    EXPECT_GT(direction * (end->beyond - end->value), 0);
    EXPECT_LT(direction * (end->beyond - end->value), 1e-12);
    EXPECT_EQ(moving(m_, *end),
              (Names{"B1", "B1l", "B1r", "B2", "B2l", "B2r", "B3", "B3l", "B3r"}));
    ASSERT_EQ(end->groups.size(), 1u);
    EXPECT_EQ(m_.groups[end->groups[0]].name, "SG-I");
    for (const char* rod : {"rod1l: B1l-C1l length", "rod2l: B2l-C2l length",
                            "rod3l: B3l-C3l length", "Tz: definition"})
      EXPECT_TRUE(is_held_by(m_, *end, rod)) << rod;
  }
}

TEST_F(DeltaPlatform, LocksInTwoArmsOrOneAcrossIt) {
  const DriverRange r = range_of(m_, 0);
  ASSERT_EQ(r.up.stop, RangeStop::dead_point);
  EXPECT_EQ(moving(m_, r.up), (Names{"B2", "B2l", "B2r", "B3", "B3l", "B3r"}));
  ASSERT_EQ(r.down.stop, RangeStop::dead_point);
  EXPECT_EQ(moving(m_, r.down), (Names{"B1", "B1l", "B1r"}));
}

/// Next to such a dead point it is not one branch that goes on beyond.
TEST_F(DeltaPlatform, GoesBackFromNextToItsLock) {
  Model m = m_;
  const double limit = -std::sqrt(0.9 * 0.9 - 0.15 * 0.15);
  for (const double before : {1e-6, 1e-11}) {
    m.drivers[2].motion = Polynomial{{limit + before}};
    const DriverRange r = range_of(m, 2);
    EXPECT_EQ(r.down.stop, RangeStop::dead_point) << before;
    EXPECT_NEAR(r.down.value, limit, 1e-12) << before;
    EXPECT_NEAR(r.up.value, -std::sqrt(0.3 * 0.3 - 0.15 * 0.15), 1e-12) << before;
    EXPECT_FALSE(r.other_branch) << before;
  }
}

/// A crank of length 2 with two couplers of 3 at its pin, and rockers of 6 about (8, 0), the one
/// above, the other below: two groups. The second rocker may be longer.
Model two_rockers(double longer) {
  const Mechanism::Vec pin{2 * std::cos(1.0), 2 * std::sin(1.0), 0};
  MechanismBuilder builder("two_rockers", 2);
  builder.set_length_unit("1");
  const int a = builder.point("A", {0, 0, 0}), b = builder.point("B", pin),
            d = builder.point("D", {8, 0, 0});
  builder.carry(MechanismBuilder::ground, {a, d});
  const int crank = builder.body("crank", {a, b});
  builder.joint(Mechanism::JointType::revolute, MechanismBuilder::ground, crank, {a});
  for (const int side : {1, -1}) {
    const std::string number = side > 0 ? "1" : "2";
    const int c = builder.point("C" + number, {3, side * 4.0, 0});
    const int coupler = builder.link("coupler" + number, b, c, 3),
              rocker = builder.link("rocker" + number, d, c, side > 0 ? 6 : 6 + longer);
    builder.joint(Mechanism::JointType::revolute, crank, coupler, {b});
    builder.joint(Mechanism::JointType::revolute, coupler, rocker, {c});
    builder.joint(Mechanism::JointType::revolute, rocker, MechanismBuilder::ground, {d});
  }
  builder.angle("theta", {-1, a, b}).driven = true;
  return model_mechanism(builder.release(), {Polynomial{{1}}}).model;
}

/// The distance of pin and pivot is 9 where the first rocker locks. A joint is off its line by
/// 2 √x where x is left of its distance. So both lock within an arc s (in lengths of some 4) where
/// the second rocker is longer by less than s² / 12: some 1e-9.
TEST(JointLocks, OfTwoGroupsAreThoseWithinAnArc) {
  const double limit = std::acos((4 + 64 - 81) / 32.0);
  for (const double longer : {0.0, 1e-12, 1e-10, 3e-8, 1e-6}) {
    const Model m = two_rockers(longer);
    const DriverRange r = range_of(m);
    ASSERT_EQ(r.up.stop, RangeStop::dead_point) << longer;
    EXPECT_NEAR(r.up.value, limit, 1e-12) << longer;
    EXPECT_GE(r.up.beyond, limit - 1e-15) << longer;
    EXPECT_LT(r.up.beyond, limit + 1e-9) << longer;
    EXPECT_EQ(moving(m, r.up), longer < 1e-9 ? (Names{"C1", "C2"}) : Names{"C1"}) << longer;
    EXPECT_EQ(r.up.groups.size(), longer < 1e-9 ? 2u : 1u) << longer;
  }
}

}  // namespace
}  // namespace desmo::joint_lock_test
