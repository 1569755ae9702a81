// Every form of a joint: its equations leave the freedoms that its row in the table says.

#include "cases/mechanism/joint_forms.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "tests/contains.h"
#include "tests/describing.h"

namespace desmo::joint_forms_test {
namespace {

class EveryJointForm : public testing::TestWithParam<JointForm> {
 protected:
  const JointForm& form = GetParam();
  const bool is_planar = form.dimension == 2;

  /// Returns a body that the joint alone joins to the ground, with so many drivers: components of
  /// three of its points in turn.
  Mechanism joined_body(int drivers) const {
    const std::array<Vec, 3> directions =
        is_planar ? std::array<Vec, 3>{{{0.6, 0.8}, {-0.8, 0.6}, {-0.6, -0.8}}}
                  : std::array<Vec, 3>{{unit({1, 2, 2}), unit({2, 1, -2}), unit({-2, 2, -1})}};
    Sketch d(std::string(form.name), form.dimension);
    const int body = d.body("body", {});
    // The ground carries common entities and the first own one, the body all but the latter.
    std::vector<int> points, vectors;
    for (int k = 0; k < form.points(); ++k) {
      points.push_back(d.point("P" + std::to_string(k), at({0.1, 0.2, 0.3}, k, directions[0])));
      if (k <= form.common_points) d.carry(Sketch::ground, {points[k]});
      if (k != form.common_points) d.carry(body, {points[k]});
    }
    for (int k = 0; k < form.vectors(); ++k) {
      vectors.push_back(d.vector("v" + std::to_string(k), directions.at(k)));
      if (k <= form.common_vectors) d.carry(Sketch::ground, {}, {vectors[k]});
      if (k != form.common_vectors) d.carry(body, {}, {vectors[k]});
    }
    d.joint(form.type, Sketch::ground, body, points, vectors);
    const std::array driven{d.point("Q", at({1.1, 0.3, -0.4})), d.point("R", at({-0.2, 1.3, 0.5})),
                            d.point("S", at({0.4, -0.6, 1.2}))};
    for (const int p : driven) d.carry(body, {p});
    for (int k = 0; k < drivers; ++k)
      d.component("c" + std::to_string(k), driven[k % 3], (k + k / 3) % form.dimension).driven =
          true;
    return d.release();
  }

  /// Returns what modelling says of that body with drivers at rest.
  std::string answer(int drivers) const {
    const Mechanism mechanism = joined_body(drivers);
    std::vector<Motion> motions;
    for (const Mechanism::Coordinate& c : mechanism.coordinates)
      motions.push_back(Polynomial{{mechanism.points[c.point].position[c.axis]}});
    return refusal([&] { model_mechanism(mechanism, motions); });
  }

 private:
  /// Returns a point, k steps along a direction from another one; in the plane where the form is.
  Vec at(Vec point, int k = 0, const Vec& direction = {}) const {
    if (is_planar) point[2] = 0;
    return point + 0.7 * k * direction;
  }
};

TEST_P(EveryJointForm, LeavesTheFreedomsOfItsRow) {
  const int freedoms = (is_planar ? 3 : 6) - form.freedoms_removed;
  if (freedoms == 0) {
    EXPECT_CONTAINS(answer(0), "no body that moves");
    return;
  }
  const std::string counted = std::to_string(freedoms) + (freedoms == 1 ? " freedom" : " freedoms");
  EXPECT_EQ(answer(freedoms), "accepted");
  EXPECT_CONTAINS(answer(freedoms + 1), "over-constrained: " + counted + " for ");
}

INSTANTIATE_TEST_SUITE_P(Table, EveryJointForm, testing::ValuesIn(joint_forms()),
                         [](const auto& info) {
                           return std::string(info.param.name) + "_" +
                                  std::to_string(info.param.dimension) + "d";
                         });

}  // namespace
}  // namespace desmo::joint_forms_test
