// What is compared with the reference, and when it counts as agreeing.

#include "bench/kit/verification.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace desmo::bench::verification_test {
namespace {

struct Verification : testing::Test {
  std::vector<ReferenceInstant> reference{{0, {1, 2}, {3, 4}, {5, 6}}, {1, {1, 2}, {3, 4}, {5, 6}}};
  VerifyingObserver observer{reference};

  void observe(int index, double time, std::vector<double> q) {
    const std::vector<double> qd{3, 4}, qdd{5, 6};
    observer.observe({index, time, q, qd, qdd});
  }
};

TEST_F(Verification, AcceptsWhatAgrees) {
  observe(0, 0, {1, 2});
  observe(1, 0.5, {7, 7});  // the reference has nothing to say here
  observe(2, 1, {1, 2 + 1e-10});
  EXPECT_EQ(verification_failure(observer.errors(), 2), "");
  EXPECT_NEAR(observer.errors().position, 1e-10, 1e-15);
}

TEST_F(Verification, RefusesWhatDiffers) {
  observe(0, 0, {1, 2});
  observe(1, 1, {1, 2 + 1e-8});
  EXPECT_NE(verification_failure(observer.errors(), 2), "");
}

TEST_F(Verification, RefusesWhatIsNotANumber) {
  observe(0, 0, {1, NAN});
  observe(1, 1, {1, 2});
  EXPECT_NE(verification_failure(observer.errors(), 2), "");
}

TEST_F(Verification, RefusesWhatIsMissing) {
  observe(0, 0, {});
  observe(1, 1, {1, 2});
  EXPECT_NE(verification_failure(observer.errors(), 2), "");
}

/// Two under way at once, as when several instants are solved together; the later may come first.
TEST_F(Verification, ComparesWhatStandsInRooms) {
  const auto come = [&](std::array<double, 2> second, std::array<int, 2> order) {
    const std::array indices{0, 1};
    std::array<Room, 2> rooms;
    observer.take_rooms(indices, rooms);
    for (int i = 0; i < 2; ++i)
      for (int k = 0; k < 2; ++k) {
        rooms[i].q[k] = k == 0 ? 1 : second[i];
        rooms[i].qd[k] = 3 + k;
        rooms[i].qdd[k] = 5 + k;
      }
    for (const int i : order)
      observer.observe({i, static_cast<double>(i), {}, {}, {}, 0, 0, false, rooms[i]});
  };
  come({2, 2 + 1e-10}, {0, 1});
  EXPECT_EQ(verification_failure(observer.errors(), 2), "");
  EXPECT_NEAR(observer.errors().position, 1e-10, 1e-15);
  come({2, 2.5}, {1, 0});  // once more: what comes later holds
  EXPECT_EQ(observer.errors().instants, 2);
  EXPECT_NEAR(observer.errors().position, 0.5, 1e-15);
}

TEST_F(Verification, RefusesInstantsThatWereNeverSeen) {
  observe(0, 0, {1, 2});
  EXPECT_NE(verification_failure(observer.errors(), 2), "");
}

}  // namespace
}  // namespace desmo::bench::verification_test
