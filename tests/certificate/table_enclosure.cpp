// Tables in proofs: what encloses a spline within a distance holds it on either side of knots.

#include "formulations/verification/certificate/table_enclosure.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "cases/mechanism/motion.h"
#include "formulations/constraints/table.h"

namespace desmo::table_enclosure_test {
namespace {

std::vector<double> numbers_of(const std::vector<double>& at, const std::vector<double>& values,
                               SplineEnds ends) {
  const Spline f = make_spline(at, values, ends);
  const bool repeats = ends == SplineEnds::indexing;
  std::vector<double> t{double(f.pieces().size()), repeats ? 1.0 : 0.0,
                        repeats ? values.back() - values.front() : 0};
  t.insert(t.end(), at.begin(), at.end());
  for (const Spline::Piece& piece : f.pieces())
    for (const Derived& c : piece) t.push_back(c.value);
  return t;
}

template <int k>
void expect_within(const std::vector<double>& t, double at, double distance) {
  const auto number = [&](int i) { return Derived(t[i]); };
  const std::array<Derived, 4> a = enclose_table(number, at, distance);
  constexpr double binomial[4][4] = {{1, 1, 1, 1}, {0, 1, 2, 3}, {0, 0, 1, 3}, {0, 0, 0, 1}};
  for (const double share : {-1.0, -0.6, -0.1, 0.0, 0.3, 0.8, 1.0}) {
    const long double y = share * distance;
    long double sum = 0, radius = 1e-15L;
    for (int l = 3; l >= k; --l) {
      sum = sum * y + binomial[k][l] * (a[l].value + (long double)a[l].correction);
      radius = radius * std::abs(y) + binomial[k][l] * a[l].radius;
    }
    const auto wide = [&](int i) { return (long double)t[i]; };
    EXPECT_NEAR(double(table_number<k>(wide, at + y)), double(sum), double(radius) + 1e-14)
        << k << " at " << at << " + " << double(y);
  }
}

TEST(TableEnclosure, HoldsTheSplineOnBothSidesOfKnots) {
  const std::vector<double> at{0, 1, 1.5, 3, 4}, values{0, 2, 1, 2, 5};
  for (const SplineEnds ends : {SplineEnds::natural, SplineEnds::indexing}) {
    const std::vector<double> t = numbers_of(at, values, ends);
    for (const double x : {0.0, 0.3, 1.0, 1.49, 1.5, 2.9, 3.999, 4.0})
      for (const double distance : {0.0, 1e-9, 0.02, 0.6}) {
        const bool leaves = ends == SplineEnds::natural && (x - distance < 0 || x + distance > 4);
        if (leaves) continue;  // outer pieces are continued there
        expect_within<0>(t, x, distance);
        expect_within<1>(t, x, distance);
        expect_within<2>(t, x, distance);
      }
  }
}

TEST(TableEnclosure, IsUnboundedWhereItReachesTooFar) {
  const std::vector<double> t = numbers_of({0, 1, 2, 3}, {0, 1, 3, 4}, SplineEnds::indexing);
  const auto number = [&](int i) { return Derived(t[i]); };
  EXPECT_TRUE(std::isfinite(enclose_table(number, 100, 10)[0].radius));
  EXPECT_TRUE(std::isinf(enclose_table(number, 100, 30)[0].radius));
}

/// A table that does not repeat has no values beyond its ends, so that no step leads there and
/// back.
TEST(TableEnclosure, IsUnboundedWhereItLeadsOutOfTheTable) {
  const std::vector<double> t = numbers_of({0, 1, 2}, {0, 1, 3}, SplineEnds::natural);
  const auto number = [&](int i) { return Derived(t[i]); };
  const double margin = 2e-9;  // 1e-9 of its length
  for (const double at : {0.4, 1.5})
    for (const double beyond : {-margin, margin / 3, margin * 3, 0.1}) {
      const double distance = (at < 1 ? at : 2 - at) + beyond;
      EXPECT_EQ(std::isfinite(enclose_table(number, at, distance)[0].radius), beyond < margin)
          << at << ", " << beyond;
    }
}

TEST(Table, EndsWithinAMarginForRounding) {
  const std::vector<double> t = numbers_of({0, 1, 2}, {0, 1, 3}, SplineEnds::natural);
  const double margin = 2e-9;  // 1e-9 of its length
  for (const double end : {0.0, 2.0}) {
    const double way = end > 0 ? 1 : -1;
    EXPECT_TRUE(std::isfinite(table_coefficient<0>(t.data(), end + way * margin / 3)));
    EXPECT_TRUE(std::isnan(table_coefficient<0>(t.data(), end + way * margin * 3)));
  }
}

}  // namespace
}  // namespace desmo::table_enclosure_test
