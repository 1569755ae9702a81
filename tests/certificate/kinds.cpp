// Every constraint kind in intervals against quadruple precision: Φ, Φ_q, Φ̇ and Φ̈ hold what
// numbers from the operands give, near the origin and far from it, for large and small links. No
// radius is more than 20 times the worst distance seen.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/float128.hpp>
#include <random>
#include <vector>

#include "formulations/constraints/constraints.h"
#include "formulations/groupwise/jet.h"
#include "formulations/verification/certificate/interval.h"

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
  using Values = std::array<std::array<S, 3>, operands>;

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

template <class S, std::size_t N>
std::array<const S*, N> pointers(const std::array<std::array<S, 3>, N>& x) {
  std::array<const S*, N> p;
  for (std::size_t k = 0; k < N; ++k) p[k] = x[k].data();
  return p;
}

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

template <class Kind, class S, class Values, class Constants>
std::vector<S> quadratic(const Values& q, const Values& qd, const Constants& c) {
  std::vector<S> gamma(Kind::rows);
  Kind::quadratic(pointers(q).data(), pointers(qd).data(), c.data(), gamma.data());
  return gamma;
}

template <class Kind, class S, class Values, class Constants>
std::vector<Jet<S>> motion(const Values& q, const Values& qd, const Values& qdd,
                           const Constants& c) {
  std::array<std::array<Jet<S>, 3>, Kind::operand_sizes.size()> x;
  for (std::size_t k = 0; k < x.size(); ++k)
    for (int i = 0; i < Kind::operand_sizes[k]; ++i) x[k][i] = {q[k][i], qd[k][i], qdd[k][i]};
  std::array<Jet<S>, Kind::constants + 1> constants;
  std::copy(c.begin(), c.end(), constants.begin());
  return residual<Kind, Jet<S>>(x, constants);
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
template <class Tuple>
struct TypesOf;
template <class... Kinds>
struct TypesOf<std::tuple<Kinds...>> {
  using type = testing::Types<Kinds...>;
};
TYPED_TEST_SUITE(KindInIntervals, TypesOf<ConstraintKinds>::type);

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
    Worst of_phi, of_jacobian, of_quadratic, of_velocity, of_acceleration;
    for (int i = 0; i < 1000; ++i) {
      const Sample<Kind> s(generator, place);
      of_phi.compare(residual<Kind, Interval>(s.q, s.c), residual<Kind, Wide>(s.exact_q, s.exact_c),
                     "phi");
      of_jacobian.compare(jacobian<Kind, Interval>(s.q, s.c),
                          jacobian<Kind, Wide>(s.exact_q, s.exact_c), "jacobian");
      of_quadratic.compare(quadratic<Kind, Interval>(s.q, s.qd, s.c),
                           quadratic<Kind, Wide>(s.exact_q, s.exact_qd, s.exact_c), "quadratic");
      const auto found = motion<Kind, Interval>(s.q, s.qd, s.qdd, s.c);
      const auto exact = motion<Kind, Wide>(s.exact_q, s.exact_qd, s.exact_qdd, s.exact_c);
      of_velocity.compare(part(found, &Jet<Interval>::first), part(exact, &Jet<Wide>::first),
                          "velocity");
      of_acceleration.compare(part(found, &Jet<Interval>::second), part(exact, &Jet<Wide>::second),
                              "acceleration");
    }
    of_phi.expect_tight("phi");
    of_jacobian.expect_tight("jacobian");
    of_quadratic.expect_tight("quadratic");
    of_velocity.expect_tight("velocity");
    of_acceleration.expect_tight("acceleration");
  }
}

TYPED_TEST(KindInIntervals, IsHomogeneousWhereLinear) {
  if constexpr (TypeParam::linear) {  // Φ̇ is Φ of the velocities, as IntervalBlock evaluates it
    std::mt19937 generator(1);
    const Sample<TypeParam> s(generator, {0, 1, 0});
    const auto rates = residual<TypeParam, Wide>(s.exact_qd, s.exact_c);
    const auto exact = motion<TypeParam, Wide>(s.exact_q, s.exact_qd, s.exact_qdd, s.exact_c);
    for (std::size_t r = 0; r < rates.size(); ++r) EXPECT_LT(abs(rates[r] - exact[r].first), 1e-30);
  }
}

}  // namespace
}  // namespace desmo::interval_kinds_test
