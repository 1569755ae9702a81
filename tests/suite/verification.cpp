// What is compared with the reference, and when it counts as agreeing.

#include "bench/suite/verification.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace desmo::suite {
namespace {

struct Verification : testing::Test {
  std::vector<ReferenceInstant> reference{{0, {1, 2}, {3, 4}, {5, 6}}, {1, {1, 2}, {3, 4}, {5, 6}}};
  VerifyingSink sink{reference};

  void accept(int index, double time, std::vector<double> q) {
    const std::vector<double> qd{3, 4}, qdd{5, 6};
    sink.accept({index, time, q, qd, qdd});
  }
};

TEST_F(Verification, AcceptsWhatAgrees) {
  accept(0, 0, {1, 2});
  accept(1, 0.5, {7, 7});  // the reference has nothing to say here
  accept(2, 1, {1, 2 + 1e-10});
  EXPECT_EQ(complaint(sink.errors(), 2), "");
  EXPECT_NEAR(sink.errors().position, 1e-10, 1e-15);
}

TEST_F(Verification, RefusesWhatDiffers) {
  accept(0, 0, {1, 2});
  accept(1, 1, {1, 2 + 1e-8});
  EXPECT_NE(complaint(sink.errors(), 2), "");
}

TEST_F(Verification, RefusesWhatIsNotANumber) {
  accept(0, 0, {1, NAN});
  accept(1, 1, {1, 2});
  EXPECT_NE(complaint(sink.errors(), 2), "");
}

TEST_F(Verification, RefusesWhatIsMissing) {
  accept(0, 0, {});
  accept(1, 1, {1, 2});
  EXPECT_NE(complaint(sink.errors(), 2), "");
}

/// Two under way at once, as when several instants are solved together.
TEST_F(Verification, ComparesWhatStandsInRooms) {
  const auto fill = [&](int index, double second) {
    const Room room = sink.room(index);
    for (int k = 0; k < 2; ++k) {
      room.q[k] = k == 0 ? 1 : second;
      room.qd[k] = 3 + k;
      room.qdd[k] = 5 + k;
    }
  };
  const auto accept_both = [&] {
    sink.accept({0, 0, {}, {}, {}, 0, 0, false, true});
    sink.accept({1, 1, {}, {}, {}, 0, 0, false, true});
  };
  fill(0, 2);
  fill(1, 2 + 1e-10);
  accept_both();
  EXPECT_EQ(complaint(sink.errors(), 2), "");
  EXPECT_NEAR(sink.errors().position, 1e-10, 1e-15);
  fill(0, 2);
  fill(1, 2.5);  // once more: what comes later holds
  accept_both();
  EXPECT_EQ(sink.errors().instants, 2);
  EXPECT_NEAR(sink.errors().position, 0.5, 1e-15);
}

TEST_F(Verification, RefusesInstantsThatWereNeverSeen) {
  accept(0, 0, {1, 2});
  EXPECT_NE(complaint(sink.errors(), 2), "");
}

}  // namespace
}  // namespace desmo::suite
