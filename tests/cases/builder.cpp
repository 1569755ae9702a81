// Mechanisms built in code: their joints have the names that they would have in a file.

#include "cases/mechanism/builder.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cases/io/files.h"
#include "tests/refusal.h"

namespace desmo::builder_test {
namespace {

constexpr auto revolute = Mechanism::JointType::revolute;

/// A crank on a revolute joint, and a rod that hangs on it by two, of which one may have a name.
Mechanism crank_and_rod(const std::string& name) {
  MechanismBuilder builder("crank_and_rod", 2);
  const int a = builder.point("A", {0, 0}), b = builder.point("B", {1, 0}),
            c = builder.point("C", {2, 0});
  const int crank = builder.body("crank", {a, b, c}), rod = builder.body("rod", {b, c});
  builder.carry(MechanismBuilder::ground, {a});
  builder.joint(revolute, MechanismBuilder::ground, crank, {a});
  builder.joint(revolute, crank, rod, {b}, {}, name);
  builder.joint(revolute, crank, rod, {c});
  return builder.release();
}

std::vector<std::string> joint_names(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (const Mechanism::Joint& joint : mechanism.joints) names.push_back(joint.name);
  return names;
}

TEST(Builder, NamesJointsAsFilesDo) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(joint_names(crank_and_rod("")),
            (Names{"revolute/ground/crank", "revolute/crank/rod", "revolute/crank/rod/2"}));
  EXPECT_EQ(joint_names(crank_and_rod("pin")),
            (Names{"revolute/ground/crank", "pin", "revolute/crank/rod"}));
  EXPECT_EQ(joint_names(crank_and_rod("revolute/crank/rod")),
            (Names{"revolute/ground/crank", "revolute/crank/rod", "revolute/crank/rod/2"}));
  const Mechanism built = crank_and_rod("pin");
  EXPECT_EQ(joint_names(parse_mechanism(write_mechanism(built), "m.json")), joint_names(built));
}

TEST(Builder, LeavesWhatIsWrongToValidation) {
  const auto refusal = [](const auto& change) {
    MechanismBuilder builder("wrong", 2);
    const int p = builder.point("P", {0, 0});
    const int body = builder.body("body", {p});
    builder.carry(MechanismBuilder::ground, {p});
    change(builder, body, p);
    return desmo::refusal([&] { validate(builder.release()); });
  };
  EXPECT_EQ(refusal([](auto& b, int body, int p) { b.joint(revolute, 0, body, {p}); }), "accepted");
  EXPECT_EQ(refusal([](auto& b, int body, int p) { b.joint(revolute, body, 7, {p}); }),
            "joint 'revolute/body/7': joins a body that does not exist");
  EXPECT_EQ(refusal([](auto& b, int body, int p) {
              b.joint(static_cast<Mechanism::JointType>(99), 0, body, {p});
            }),
            "joint 'joint/ground/body': has a type that does not exist");
  EXPECT_EQ(refusal([](auto& b, int body, int p) {
              b.joint(revolute, 0, body, {p}, {}, "pin");
              b.joint(revolute, 0, body, {p}, {}, "pin");
            }),
            "joint 'pin': the name is given twice among the joints; rename one");
}

}  // namespace
}  // namespace desmo::builder_test
