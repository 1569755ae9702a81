// Comparisons with the reference: values, scales and instants that agree, and that do not.

#include "bench/kit/verification.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "cases/generators/cases.h"
#include "cases/io/files.h"
#include "formulations/base/per_level.h"
#include "formulations/model/scales.h"
#include "formulations/modelling/modelling.h"

namespace desmo::bench::verification_test {
namespace {

struct Verification : testing::Test {
  std::vector<ReferenceInstant> reference{{0, {1, 2}, {3, 4}, {5, 6}}, {1, {1, 2}, {3, 4}, {5, 6}}};
  ComparingObserver observer{2, Level::acceleration, reference,
                             all_compared(2, Level::acceleration)};

  /// Writes to memory that an observer lends, as a solver does.
  static void show(ComparingObserver& observer, int index, double time, std::array<double, 2> q) {
    Instant instant{index, time, {}, {}, {}};
    observer.lend({&index, 1}, {&instant.output, 1});
    show(instant, q);
    observer.observe(instant);
  }
  static void show(Instant& instant, std::array<double, 2> q) {
    const OutputView& lent = instant.output;
    for (int k = 0; k < 2; ++k) lent.q[k] = q[k], lent.qd[k] = 3 + k, lent.qdd[k] = 5 + k;
    instant.q = {lent.q, 2}, instant.qd = {lent.qd, 2}, instant.qdd = {lent.qdd, 2};
  }
};

TEST_F(Verification, AcceptsWhatAgreesAndRefusesWhatDoesNot) {
  show(observer, 0, 0, {1, 2});
  EXPECT_NE(verification_failure(observer.compare().errors, 2), "");  // an instant is missing
  show(observer, 1, 0.5, {7, 7});  // the reference has nothing to say here
  for (const auto& [second, is_right] :
       {std::pair{2 + 1e-10, true}, {2 + 1e-8, false}, {double{NAN}, false}}) {
    show(observer, 2, 1, {1, second});
    EXPECT_EQ(verification_failure(observer.compare().errors, 2).empty(), is_right) << second;
  }
}

/// Two under way at once, as when several instants are solved together; the later may come first.
TEST_F(Verification, ComparesInstantsInAnyOrder) {
  const auto come = [&](std::array<double, 2> second, std::array<int, 2> order) {
    const std::array indices{0, 1};
    std::array<OutputView, 2> lent;
    observer.lend(indices, lent);
    for (const int i : order) {
      Instant instant{i, static_cast<double>(i), {}, {}, {}, 0, 0, false, lent[i]};
      show(instant, {1, second[i]});
      observer.observe(instant);
    }
  };
  come({2, 2 + 1e-10}, {0, 1});
  EXPECT_EQ(verification_failure(observer.compare().errors, 2), "");
  EXPECT_NEAR(observer.compare().errors.position, 1e-10, 1e-15);
  come({2, 2.5}, {1, 0});  // once more: what comes later holds
  EXPECT_EQ(observer.compare().errors.instants, 2);
  EXPECT_NEAR(observer.compare().errors.position, 0.5, 1e-15);
}

/// Differences are divided by scales: 2 km for the first coordinate here, 1 for the second.
TEST_F(Verification, ComparesRelativelyToScales) {
  const PerLevel<std::vector<double>> scales{{2000, 1}, {1, 1}, {1, 1}};
  const auto failure = [&](double first, double second) {
    ComparingObserver scaled(2, Level::acceleration, reference,
                             all_compared(2, Level::acceleration, scales));
    for (const int i : {0, 1}) show(scaled, i, i, {1 + first, 2 + second});
    return verification_failure(scaled.compare().errors, 2);
  };
  EXPECT_EQ(failure(2000 * 0.9e-9, 0.9e-9), "");
  EXPECT_NE(failure(2000 * 2e-9, 0), "");
  EXPECT_NE(failure(0, 2e-9), "");
}

TEST(Scales, AreThoseOfEachCoordinate) {
  const Model m = make_model(library_scene("slider_crank"));
  std::vector<double> rates(m.coordinates(), 3), still(m.coordinates(), 0);
  const auto moving = coordinate_scales(m, std::vector<ReferenceInstant>{{0, rates, rates, rates}});
  const auto at_rest =
      coordinate_scales(m, std::vector<ReferenceInstant>{{0, rates, still, still}});
  const double size = nominal_size(m);
  EXPECT_NE(size, 1);
  for (const Entity& e : m.entities) {
    if (e.fixed) continue;
    EXPECT_EQ(moving.position[e.first], is_length(e.kind) ? size : 1);
    EXPECT_NEAR(moving.velocity[e.first], 3 * std::sqrt(2), 1e-12);  // of a point, of a vector
    for (const Level rate : rate_levels) EXPECT_EQ(at_rest[rate][e.first], 1);
  }
}

/// Every fourth of 201 instants is solved; every fourth of the ordinary times is among these.
TEST(References, OfStridesHaveInstantsThatAreInterpolated) {
  const Model m = make_model(four_bar(1));
  const TimeGrid grid{0, 0.01, 201};
  const auto interpolated = [&](std::span<const ReferenceInstant> reference) {
    return std::ranges::count_if(reference, [&](const ReferenceInstant& r) {
      return std::lround(r.time / grid.step) % 4 != 0;
    });
  };
  EXPECT_EQ(interpolated(shared_reference(m, grid)), 0);
  EXPECT_GT(interpolated(shared_reference(m, grid, 4)), 20);
}

/// Two models of one name and size may differ in a dimension.
TEST(References, AreThoseOfTheModel) {
  const TimeGrid grid{0, 0.01, 3};
  Model m = make_model(four_bar(1));
  const double before = shared_reference(m, grid).back().q.front();
  for (Driver& driver : m.drivers) driver.motion = Polynomial{{0.1, 2}};
  EXPECT_NE(shared_reference(m, grid).back().q.front(), before);
}

}  // namespace
}  // namespace desmo::bench::verification_test
