// Every constraint kind against quadruple precision: Φ, Φ̇ and Φ̈ in compensated arithmetic, and
// Φ_q, Φ̇_q and Φ̈_q in intervals hold what numbers from the operands give, near the origin and far
// from it, for large and small links. No radius is more than 20 times the worst distance seen.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/float128.hpp>
#include <random>
#include <vector>

#include "formulations/constraints/jet.h"
#include "formulations/verification/certificate/block_equations.h"
#include "tests/cases/operands.h"

namespace desmo::interval_kinds_test {
namespace {

using Wide = boost::multiprecision::float128;
constexpr double max_excess = 20;

/// How far points are from the origin, how long links are, and how uncertain all of it is.
struct Place {
  double offset, size, radius;
};

/// Numbers for the operands of a kind, as intervals and as one choice from each.
template <class Kind>
struct Sample {
  static constexpr std::size_t operands = Kind::operand_sizes.size();
  template <class S>
  using Values = std::array<std::array<S, max_components>, operands>;

  Sample(std::mt19937& generator, const Place& place) {
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto fill = [&](Values<Interval>& x, Values<Wide>& chosen, double offset, double size) {
      for (std::size_t k = 0; k < operands; ++k)
        for (int i = 0; i < Kind::operand_sizes[k]; ++i) {
          // A scalar is an angle or a distance; an offset is common to all points.
          const bool scalar = Kind::operand_sizes[k] == 1;
          const double mid =
              scalar ? 2 * uniform(generator) : offset * (i + 1) + size * uniform(generator);
          x[k][i] = {mid, place.radius * (scalar ? 1 : size) * std::abs(uniform(generator))};
          const double share = std::clamp(2 * uniform(generator), -1.0, 1.0);
          chosen[k][i] = Wide(x[k][i].mid) + Wide(x[k][i].radius) * share;
        }
    };
    fill(q, exact_q, place.offset, place.size);
    fill(qd, exact_qd, 0, 1);
    fill(qdd, exact_qdd, 0, 1);
    for (int i = 0; i < Kind::constants; ++i) {
      c[i] = uniform(generator);
      exact_c[i] = Wide(c[i].mid);
    }
  }

  Values<Interval> q, qd, qdd;
  Values<Wide> exact_q, exact_qd, exact_qdd;
  std::array<Interval, Kind::constants + 1> c;
  std::array<Wide, Kind::constants + 1> exact_c;
};

template <class Kind, class S, class Values, class Constants>
std::vector<S> residual(const Values& q, const Constants& c) {
  std::vector<S> phi(Kind::rows);
  Kind::residual(pointers(q).data(), c.data(), phi.data());
  return phi;
}

template <class Kind, class S, class Values, class Constants>
std::vector<S> jacobian(const Values& q, const Constants& c) {
  std::vector<S> entries;
  Kind::jacobian(pointers(q).data(), c.data(),
                 [&](int, int, int, const S& value) { entries.push_back(value); });
  return entries;
}

/// Returns operands and constants with their rates.
template <class Kind, class S, class Values>
auto moving(const Values& q, const Values& qd, const Values& qdd) {
  std::array<std::array<Jet<S>, max_components>, Kind::operand_sizes.size()> x;
  for (std::size_t k = 0; k < x.size(); ++k)
    for (int i = 0; i < Kind::operand_sizes[k]; ++i) x[k][i] = {q[k][i], qd[k][i], qdd[k][i]};
  return x;
}
template <class S, std::size_t N>
std::array<Jet<S>, N> resting(const std::array<S, N>& c) {
  std::array<Jet<S>, N> constants;
  std::ranges::copy(c, constants.begin());
  return constants;
}

/// Largest distances seen over radii, of each of several numbers.
class Worst {
 public:
  void compare(const std::vector<Interval>& found, const std::vector<Wide>& exact,
               const char* what) {
    worst_.resize(found.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      const Wide off = abs(exact[i] - Wide(found[i].mid));
      const Wide of_reference = abs(exact[i]) * 1e-33;  // its own rounding
      EXPECT_LE(off, Wide(found[i].radius) + of_reference) << what << ' ' << i;
      worst_[i] = std::max(worst_[i], static_cast<double>(off / std::max(found[i].radius, 1e-100)));
    }
  }
  void expect_tight(const char* what) const {
    for (std::size_t i = 0; i < worst_.size(); ++i) {
      const bool always_exact = worst_[i] == 0;
      EXPECT_TRUE(always_exact || worst_[i] * max_excess >= 1)
          << what << ' ' << i << ": " << worst_[i];
    }
  }

 private:
  std::vector<double> worst_;
};

template <class Kind>
class KindInIntervals : public testing::Test {};
TYPED_TEST_SUITE(KindInIntervals, EveryKind);

template <class S>
std::vector<S> part(const std::vector<Jet<S>>& jets, S Jet<S>::*order) {
  std::vector<S> values;
  for (const Jet<S>& j : jets) values.push_back(j.*order);
  return values;
}

TYPED_TEST(KindInIntervals, HoldsAllThatItsOperandsHold) {
  using Kind = TypeParam;
  for (const Place& place : {Place{0, 1, 0},
                             {0, 1, 1e-12},
                             {0, 1, 1e-3},
                             {1e6, 1, 0},
                             {1e6, 1e-3, 1e-5},
                             {0, 1e-3, 0},
                             {0, 1e3, 1e-12}}) {
    SCOPED_TRACE(testing::Message() << "offset " << place.offset << " size " << place.size
                                    << " radius " << place.radius);
    std::mt19937 generator(1);
    Worst of_jacobian, of_first, of_second;
    for (int i = 0; i < 400; ++i) {
      const Sample<Kind> s(generator, place);
      of_jacobian.compare(jacobian<Kind, Interval>(s.q, s.c),
                          jacobian<Kind, Wide>(s.exact_q, s.exact_c), "jacobian");
      const auto found =
          jacobian<Kind, Jet<Interval>>(moving<Kind, Interval>(s.q, s.qd, s.qdd), resting(s.c));
      const auto exact = jacobian<Kind, Jet<Wide>>(
          moving<Kind, Wide>(s.exact_q, s.exact_qd, s.exact_qdd), resting(s.exact_c));
      of_first.compare(part(found, &Jet<Interval>::first), part(exact, &Jet<Wide>::first), "first");
      of_second.compare(part(found, &Jet<Interval>::second), part(exact, &Jet<Wide>::second),
                        "second");
    }
    of_jacobian.expect_tight("jacobian");
    of_first.expect_tight("first");
    of_second.expect_tight("second");
  }
}

using Number = Compensated<LaneNumbers>;

/// Returns the numbers of four samples, a lane each.
template <class Kind>
auto in_lanes(const std::array<Sample<Kind>, 4>& samples, auto Sample<Kind>::*member) {
  std::array<std::array<Number, max_components>, Kind::operand_sizes.size()> x;
  for (std::size_t k = 0; k < x.size(); ++k)
    for (int i = 0; i < Kind::operand_sizes[k]; ++i)
      for (int lane = 0; lane < 4; ++lane)
        x[k][i].value.set(lane, (samples[lane].*member)[k][i].mid);
  return x;
}

TYPED_TEST(KindInIntervals, HasResidualsWithoutRounding) {
  using Kind = TypeParam;
  for (const Place& place : {Place{0, 1, 0}, {1e6, 1, 0}, {1e6, 1e-3, 0}, {0, 1e-3, 0}}) {
    SCOPED_TRACE(testing::Message() << "offset " << place.offset << " size " << place.size);
    std::mt19937 generator(1);
    std::array<std::vector<double>, 3> worst;
    for (std::vector<double>& w : worst) w.resize(Kind::rows);
    for (int i = 0; i < 120; ++i) {
      const std::array<Sample<Kind>, 4> s{Sample<Kind>(generator, place),
                                          {generator, place},
                                          {generator, place},
                                          {generator, place}};
      std::array<Number, Kind::constants + 1> c;
      for (int k = 0; k < Kind::constants; ++k)
        for (int lane = 0; lane < 4; ++lane) c[k].value.set(lane, s[lane].c[k].mid);
      const auto found = residual<Kind, Jet<Number>>(
          moving<Kind, Number>(in_lanes(s, &Sample<Kind>::q), in_lanes(s, &Sample<Kind>::qd),
                               in_lanes(s, &Sample<Kind>::qdd)),
          resting(c));
      for (int lane = 0; lane < 4; ++lane) {
        const auto exact = residual<Kind, Jet<Wide>>(
            moving<Kind, Wide>(s[lane].exact_q, s[lane].exact_qd, s[lane].exact_qdd),
            resting(s[lane].exact_c));
        const auto compare = [&](const Number& f, const Wide& e, double& w) {
          const Wide off = abs(e - Wide(f.value[lane]) - Wide(f.correction[lane]));
          const Wide of_reference = 1e-33 * (1 + place.offset * place.offset);
          EXPECT_LE(off, Wide(f.radius[lane]) + of_reference) << i << " in lane " << lane;
          const LaneInterval all = f.enclosure();
          EXPECT_LE(abs(e - Wide(all.mid[lane])), Wide(all.radius[lane]) + of_reference);
          if (f.radius[lane] > 0) w = std::max(w, static_cast<double>(off / f.radius[lane]));
        };
        for (int r = 0; r < Kind::rows; ++r) {
          compare(found[r].value, exact[r].value, worst[0][r]);
          compare(found[r].first, exact[r].first, worst[1][r]);
          compare(found[r].second, exact[r].second, worst[2][r]);
        }
      }
    }
    for (const std::vector<double>& w : worst)
      for (const double seen : w) EXPECT_TRUE(seen == 0 || seen * max_excess >= 1) << seen;
  }
}

}  // namespace
}  // namespace desmo::interval_kinds_test
