// Every constraint kind against quadruple precision: Φ, Φ̇ and Φ̈ in compensated arithmetic, and
// Φ_q, Φ̇_q and Φ̈_q in intervals hold what numbers from the operands give, near the origin and far
// from it, for large and small links. No radius is more than 20 times the worst distance seen.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/float128.hpp>
#include <random>
#include <type_traits>
#include <vector>

#include "cases/numbers/compensated.h"
#include "cases/numbers/interval.h"
#include "formulations/constraints/jet.h"
#include "tests/cases/operands.h"

namespace desmo::interval_kinds_test {
namespace {

using Wide = boost::multiprecision::float128;
constexpr double max_excess = 20;

/// Distance of points from the origin, length of links, and uncertainty of all of it.
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

using Number = Compensated<double>;

/// Returns a number in the scalar S: of an interval, its midpoint.
template <class S, class From>
S in_scalar(const From& x) {
  if constexpr (std::is_same_v<S, From>)
    return x;
  else
    return S(x.mid);
}

/// Return operands and constants with their rates, in the scalar S.
template <class Kind, class S, class Values>
auto moving(const Values& q, const Values& qd, const Values& qdd) {
  std::array<std::array<Jet<S>, max_components>, Kind::operand_sizes.size()> x;
  for (std::size_t k = 0; k < x.size(); ++k)
    for (int i = 0; i < Kind::operand_sizes[k]; ++i)
      x[k][i] = {in_scalar<S>(q[k][i]), in_scalar<S>(qd[k][i]), in_scalar<S>(qdd[k][i])};
  return x;
}
template <class S, class From, std::size_t N>
std::array<Jet<S>, N> resting(const std::array<From, N>& c) {
  std::array<Jet<S>, N> constants;
  for (std::size_t k = 0; k < N; ++k) constants[k] = in_scalar<S>(c[k]);
  return constants;
}

Wide centre_of(const Interval& x) { return x.mid; }
Wide centre_of(const Number& x) { return Wide(x.value) + Wide(x.correction); }

/// Largest distances seen over radii, of each of several numbers.
class Worst {
 public:
  explicit Worst(const Place& place) : of_reference_(1e-33 * (1 + place.offset * place.offset)) {}

  template <class S>
  void compare(const std::vector<S>& found, const std::vector<Wide>& exact, const char* what) {
    worst_.resize(found.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      const Wide off = abs(exact[i] - centre_of(found[i]));
      const Wide of_reference = of_reference_ + abs(exact[i]) * 1e-33;  // its own rounding
      EXPECT_LE(off, Wide(found[i].radius) + of_reference) << what << ' ' << i;
      if (found[i].radius > 0)
        worst_[i] = std::max(worst_[i], static_cast<double>(off / found[i].radius));
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
  Wide of_reference_;
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
    Worst of_jacobian(place), of_first(place), of_second(place);
    for (int i = 0; i < 400; ++i) {
      const Sample<Kind> s(generator, place);
      of_jacobian.compare(jacobian<Kind, Interval>(s.q, s.c),
                          jacobian<Kind, Wide>(s.exact_q, s.exact_c), "jacobian");
      const auto found = jacobian<Kind, Jet<Interval>>(moving<Kind, Interval>(s.q, s.qd, s.qdd),
                                                       resting<Interval>(s.c));
      const auto exact = jacobian<Kind, Jet<Wide>>(
          moving<Kind, Wide>(s.exact_q, s.exact_qd, s.exact_qdd), resting<Wide>(s.exact_c));
      of_first.compare(part(found, &Jet<Interval>::first), part(exact, &Jet<Wide>::first), "first");
      of_second.compare(part(found, &Jet<Interval>::second), part(exact, &Jet<Wide>::second),
                        "second");
    }
    of_jacobian.expect_tight("jacobian");
    of_first.expect_tight("first");
    of_second.expect_tight("second");
  }
}

TYPED_TEST(KindInIntervals, HasResidualsWithoutRounding) {
  using Kind = TypeParam;
  for (const Place& place : {Place{0, 1, 0}, {1e6, 1, 0}, {1e6, 1e-3, 0}, {0, 1e-3, 0}}) {
    SCOPED_TRACE(testing::Message() << "offset " << place.offset << " size " << place.size);
    std::mt19937 generator(1);
    Worst of_value(place), of_first(place), of_second(place);
    for (int i = 0; i < 480; ++i) {
      const Sample<Kind> s(generator, place);
      const auto found =
          residual<Kind, Jet<Number>>(moving<Kind, Number>(s.q, s.qd, s.qdd), resting<Number>(s.c));
      const auto exact = residual<Kind, Jet<Wide>>(
          moving<Kind, Wide>(s.exact_q, s.exact_qd, s.exact_qdd), resting<Wide>(s.exact_c));
      of_value.compare(part(found, &Jet<Number>::value), part(exact, &Jet<Wide>::value), "value");
      of_first.compare(part(found, &Jet<Number>::first), part(exact, &Jet<Wide>::first), "first");
      of_second.compare(part(found, &Jet<Number>::second), part(exact, &Jet<Wide>::second),
                        "second");
    }
    of_value.expect_tight("value");
    of_first.expect_tight("first");
    of_second.expect_tight("second");
  }
}

}  // namespace
}  // namespace desmo::interval_kinds_test
