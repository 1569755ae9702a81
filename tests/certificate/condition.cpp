// The condition number of a certificate against that of the whole system.

#include "formulations/verification/condition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <vector>

#include "formulations/motion/groupwise/double_solution.h"
#include "formulations/verification/certificate/certificate.h"
#include "tests/accuracy/scenes.h"
#include "tests/certificate/containment.h"
#include "tests/dead_point.h"

namespace desmo::certified_condition_test {
namespace {

Certificate certified(const Model& m, const ReferenceInstant& s) {
  return Certifier(m).certify(instant_of(s));
}

void compare(const Model& m, const TimeGrid& grid) {
  ConditionNumber whole(m);
  double least = INFINITY, most = 0;
  for (const ReferenceInstant& s : double_solution(m, sampled(grid, DESMO_SANITIZED ? 2 : 10))) {
    const double ratio = certified(m, s).condition / whole(s.q);
    least = std::min(least, ratio);
    most = std::max(most, ratio);
  }
  std::cout << m.name << ": " << least << " to " << most << " times that of the whole\n";
  // Blocks in series multiply, and their sizes may differ from that of the mechanism.
  EXPECT_GT(least, 0.07) << m.name;
  EXPECT_LT(most, 1.5) << m.name;
}

TEST(CertifiedCondition, IsAboutThatOfTheWholeSystem) {
  for (const Scene& scene : library_scenes()) compare(make_model(scene), scene.grid);
  compare(four_bar_model(1), time_grid(3, 0.1));
  compare(truck_model(1), time_grid(3, 0.1));
}

/// It grows as the inverse root of the distance does, and so does that of the whole system.
TEST(CertifiedCondition, GrowsTowardsADeadPoint) {
  for (const double distance : {1e-3, 1e-5, 1e-7, 1e-9, 1e-11}) {
    const Model m = locking_four_bar(Polynomial{{dead_point - distance, 1}});
    const ReferenceInstant s = double_solution(m, std::array{0.0}).front();
    const Certificate c = certified(m, s);
    EXPECT_EQ(m.groups[c.worst_conditioned].name, "dyad1/SG-I");
    EXPECT_NEAR(c.condition * std::sqrt(distance), 2.6, 0.1) << distance;
    EXPECT_NEAR(c.condition / ConditionNumber(m)(s.q), 0.45, 0.02) << distance;
  }
}

/// Neither the unit of length nor the mechanism's size counts.
TEST(CertifiedCondition, DoesNotDependOnTheUnitOfLength) {
  const Scene scene = library_scene("andrews");
  std::vector<double> condition;
  for (const double factor : {1.0, 1000.0}) {
    const Model m = make_model(enlarged(scene, factor));
    condition.push_back(certified(m, double_solution(m, std::array{0.01}).front()).condition);
  }
  EXPECT_NEAR(condition[1] / condition[0], 1, 1e-6);
}

}  // namespace
}  // namespace desmo::certified_condition_test
