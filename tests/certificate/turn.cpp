// Sines and cosines in compensated arithmetic, against quadruple precision.

#include "cases/numbers/turn.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/float128.hpp>
#include <cmath>
#include <random>

#include "cases/numbers/compensated.h"
#include "formulations/verification/certificate/lane_numbers.h"

namespace desmo::turn_test {
namespace {

using Wide = boost::multiprecision::float128;
using Number = Compensated<double>;

TEST(Turn, HasABoundThatIsReached) {
  std::mt19937 generator(3);
  double worst = 0;
  for (const double largest : {1e-3, 0.03, 4.0, 1e5, 0x1p21}) {
    std::uniform_real_distribution<double> uniform(-largest, largest);
    for (int i = 0; i < 20'000; ++i) {
      const double angle = uniform(generator);
      const Turn<double> t = turn(angle);
      const Wide off = std::max<Wide>(abs(sin(Wide(angle)) - Wide(t.sine) - Wide(t.of_sine)),
                                      abs(cos(Wide(angle)) - Wide(t.cosine) - Wide(t.of_cosine)));
      ASSERT_LE(off, t.off) << angle;
      worst = std::max(worst, static_cast<double>(off / t.off));
    }
  }
  EXPECT_GT(worst, 0.5);
}

TEST(Turn, OfTheTableIsPrecise) {
  const Wide step = acos(Wide(-1)) / 64;
  for (int k = 0; k < 128; ++k) {
    const Turn<double>& t = table_of_turns()[k];
    EXPECT_LE(abs(sin(k * step) - Wide(t.sine) - Wide(t.of_sine)), 0x1p-95) << k;
    EXPECT_LE(abs(cos(k * step) - Wide(t.cosine) - Wide(t.of_cosine)), 0x1p-95) << k;
  }
}

TEST(Turn, IsTheSameInLanes) {
  for (const double far : {1.0, 0x1p22}) {  // the second by the library, for all
    LaneNumbers angles;
    for (int lane = 0; lane < LaneNumbers::count; ++lane) angles.set(lane, far * (lane - 1.7));
    const Turn<LaneNumbers> all = turn(angles);
    for (int lane = 0; lane < LaneNumbers::count; ++lane) {
      const Turn<double> one = far > 1 ? library_turn(angles[lane]) : turn(angles[lane]);
      EXPECT_EQ(all.sine[lane], one.sine);
      EXPECT_EQ(all.of_sine[lane], one.of_sine);
      EXPECT_EQ(all.cosine[lane], one.cosine);
      EXPECT_EQ(all.of_cosine[lane], one.of_cosine);
      EXPECT_EQ(all.off[lane], one.off);
    }
  }
}

/// Angles with corrections and radii of many sizes. The bound on what they add has the slope at the
/// angle: first-order terms alone depend on it.
TEST(Compensated, HoldsSinesAndCosines) {
  struct Off {
    double correction, radius;
  };
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  double worst = 0;
  for (const double largest : {1e-3, 0.8, 4.0, 1e5, 1e9})
    for (const Off& off : {Off{0, 0}, Off{1e-17, 1e-20}, Off{1e-10, 1e-13}, Off{1e-12, 0},
                           Off{1e-9, 0}, Off{1e-6, 0}, Off{1e-3, 0}, Off{0, 1e-3}})
      for (int i = 0; i < (DESMO_SANITIZED ? 50 : 2000); ++i) {
        const Number a(largest * uniform(generator), off.correction * uniform(generator),
                       off.radius);
        const Wide angle = Wide(a.value) + Wide(a.correction) + Wide(a.radius) * uniform(generator);
        const auto compare = [&](const Number& found, const Wide& exact, double slope) {
          const Wide error = abs(exact - Wide(found.value) - Wide(found.correction));
          EXPECT_LE(error, Wide(found.radius) + Wide(largest) * 1e-33) << a.value;
          const double all = off.correction + off.radius;
          EXPECT_LE(found.radius, 1e-18 + 2 * std::abs(slope) * off.radius + 2 * all * all);
          worst = std::max(worst, static_cast<double>(error / found.radius));
        };
        compare(sin(a), sin(angle), std::cos(a.value));
        compare(cos(a), cos(angle), std::sin(a.value));
      }
  EXPECT_GT(worst, 0.1);
}

}  // namespace
}  // namespace desmo::turn_test
