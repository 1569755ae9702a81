#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <variant>
#include <vector>

#include "cases/mechanism/level.h"
#include "cases/numbers/derived.h"

namespace desmo {

// Units: z [m, free unit or rad], as the coordinate has it; t [s].

/// z(t) = c₀ + c₁ t + c₂ t² + …
struct Polynomial {
  std::vector<Derived> coefficients;  ///< c₀ first; empty: z = 0
};

/// z(t) = mean + Σ amplitude sin(angular_frequency t + phase).
struct HarmonicSum {
  struct Term {
    Derived amplitude;
    Derived angular_frequency;  ///< [rad/s]
    Derived phase;              ///< [rad]
  };
  Derived mean;
  std::vector<Term> terms;
};

/// Conditions at the ends of a spline, which interpolation leaves open.
enum class SplineEnds {
  natural,   ///< z̈ = 0 at both ends
  clamped,   ///< ż = 0 at both ends
  periodic,  ///< z, ż and z̈ at the last knot are those at the first
  indexing,  ///< ż and z̈ at the last knot are those at the first; z may differ
};

/// A spline of cubic polynomials between knots. Before the first knot and after the last one the
/// outer polynomials are continued.
class Spline {
 public:
  /// Coefficients of z = c₀ + c₁ τ + c₂ τ² + c₃ τ³, where τ is the time since the interval's first
  /// knot.
  using Piece = std::array<Derived, 4>;

  /// Return the times [s] between which the motion is prescribed: the ends of a table; −∞ and ∞ for
  /// a trapezoid.
  double first_time() const { return first_time_; }
  double last_time() const { return last_time_; }
  const std::vector<double>& knots() const { return knots_; }   ///< times [s], ascending; ≥ 2
  const std::vector<Piece>& pieces() const { return pieces_; }  ///< one between each two knots
  void shift(const Derived& distance);                          ///< adds a distance to z(t)
  /// Multiplies z(t) by a factor. Throws std::invalid_argument when a coefficient overflows.
  void scale(const Derived& factor);

  friend Spline make_spline(std::vector<double> times, std::vector<double> values, SplineEnds ends);
  friend Spline make_spline(const struct Trapezoid& trapezoid);

 private:
  Spline() = default;
  void add(double knot, const Piece& piece);

  double first_time_ = -std::numeric_limits<double>::infinity();
  double last_time_ = std::numeric_limits<double>::infinity();
  std::vector<double> knots_;
  std::vector<Piece> pieces_;
};

/// Interpolates a table of times [s] and values by a spline that is twice continuously
/// differentiable. A periodic spline is not repeated outside of its table. The remainders of
/// coefficients are what they lack to those of the exact spline. Throws std::invalid_argument
/// unless
/// - there are as many times as values, two or more (periodic, indexing: three)
/// - all are finite, the times strictly ascending, and (periodic) the last value equals the first
/// - all coefficients are finite
Spline make_spline(std::vector<double> times, std::vector<double> values, SplineEnds ends);

/// The fastest motion from rest at z = 0 to rest at z = `distance` within limits of velocity and
/// acceleration: its velocity is a trapezoid over time, or a triangle.
struct Trapezoid {
  Derived distance;                ///< final z, not 0
  Derived velocity, acceleration;  ///< limits of |ż| and |z̈|, above 0
  double start = 0;                ///< time at which the motion begins [s]
};

/// Makes a spline of a trapezoid, and of the standstill before and after it. Inner knots are the
/// times at which the acceleration jumps, rounded up. The rounding changes z at no time that is a
/// double. Throws std::invalid_argument when a phase of acceleration has no duration in doubles, or
/// anything overflows.
Spline make_spline(const Trapezoid& trapezoid);

/// Prescribed motion of one independent coordinate.
using Motion = std::variant<Polynomial, HarmonicSum, Spline>;

/// Returns z(t) + distance.
Motion shifted(Motion motion, const Derived& distance);

/// z, ż and z̈ at one instant.
template <class S>
struct MotionSample {
  S position, velocity, acceleration;
};

// sample() evaluates derivatives up to the level `up_to`; those above it are 0.

/// Evaluates Σ c[i] tⁱ and its first two derivatives by Horner's rule.
template <Level up_to = Level::acceleration, class S>
MotionSample<S> sample_polynomial(std::span<const Derived> c, const S& t) {
  if (c.empty()) return {S(0), S(0), S(0)};
  S z = as<S>(c.back()), first(0), half_second(0);
  for (std::size_t i = c.size() - 1; i-- > 0;) {
    if constexpr (up_to >= Level::acceleration) half_second = half_second * t + first;
    if constexpr (up_to >= Level::velocity) first = first * t + z;
    z = z * t + as<S>(c[i]);
  }
  return {z, first, S(2) * half_second};
}

template <Level up_to = Level::acceleration, class S>
MotionSample<S> sample(const Polynomial& m, const S& t) {
  return sample_polynomial<up_to>(m.coefficients, t);
}

template <Level up_to = Level::acceleration, class S>
MotionSample<S> sample(const HarmonicSum& m, const S& t) {
  using std::cos;
  using std::sin;
  MotionSample<S> z{as<S>(m.mean), S(0), S(0)};
  for (const HarmonicSum::Term& term : m.terms) {
    const S a = as<S>(term.amplitude), w = as<S>(term.angular_frequency);
    const S angle = w * t + as<S>(term.phase);
    const S sine = sin(angle);
    z.position = z.position + a * sine;
    if constexpr (up_to >= Level::velocity) z.velocity = z.velocity + a * w * cos(angle);
    if constexpr (up_to >= Level::acceleration) z.acceleration = z.acceleration - a * w * w * sine;
  }
  return z;
}

template <Level up_to = Level::acceleration, class S>
MotionSample<S> sample(const Spline& m, const S& t) {
  // Only inner knots are searched, so that the outer polynomials are continued beyond the knots.
  const auto begin = m.knots().begin() + 1, end = m.knots().end() - 1;
  const auto i =
      std::upper_bound(begin, end, t, [](const S& time, double knot) { return time < S(knot); }) -
      begin;
  const S since_knot = t - S(m.knots()[i]);
  return sample_polynomial<up_to>(m.pieces()[i], since_knot);
}

/// Returns z(t), ż(t), z̈(t) of a motion, evaluated in the scalar S of t [s].
template <Level up_to = Level::acceleration, class S>
MotionSample<S> sample(const Motion& motion, const S& t) {
  return std::visit([&](const auto& m) { return sample<up_to>(m, t); }, motion);
}

/// Equally spaced instants. Each is computed from its index, never accumulated.
struct TimeGrid {
  double start = 0;            ///< time of the first instant [s]
  double step = 0;             ///< duration of a step [s], above 0
  int instants = 0;            ///< number of instants, both ends included; 1: the start alone
  int steps_per_interval = 1;  ///< number of steps between instants

  /// Returns start + (i · steps_per_interval) · step, each operation rounded.
  double time(int i) const;
  double interval() const { return steps_per_interval * step; }  ///< time between instants [s]

  /// Returns the grid of every nth instant from the first on, at exactly the same times. nth: ≥ 1.
  TimeGrid every(int nth) const {
    return {start, step, (instants + nth - 1) / nth, steps_per_interval * nth};
  }
};

/// Makes a grid from 0 to the multiple of `step` [s] nearest to `seconds` [s], both included.
/// Throws std::invalid_argument unless both are positive and finite and the grid has 2 to 10⁹
/// instants.
TimeGrid time_grid(double seconds, double step);

}  // namespace desmo
