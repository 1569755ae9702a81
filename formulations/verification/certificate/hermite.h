#pragma once

#include <array>

#include "cases/mechanism/level.h"

namespace desmo {

/// Value of a coordinate at an end of a path, and its derivatives with respect to s.
template <class S>
struct EndValues {
  S q, first{0}, second{0};
};

/// Coefficients c of a polynomial Σ c[k] sᵏ of degree 5 or less.
template <class S>
using Quintic = std::array<S, 6>;

/// Returns Hermite's polynomial through the values a at s = −1 and b at s = 1, with their
/// derivatives up to `level`: a chord, a cubic or a quintic.
template <class S>
Quintic<S> hermite(const EndValues<S>& a, const EndValues<S>& b, Level level) {
  const S half(0.5), three(3);
  // Half sums and half differences of the ends determine the even and the odd part by themselves.
  const S mean = (a.q + b.q) * half, rise = (b.q - a.q) * half;
  if (level == Level::position) return {mean, rise};
  const S slope = (a.first + b.first) * half, bend = (b.first - a.first) * half;
  if (level == Level::velocity)
    return {mean - bend * half, (three * rise - slope) * half, bend * half, (slope - rise) * half};
  const S curvature = (a.second + b.second) * half, twist = (b.second - a.second) * half;
  const S fourth = (curvature - bend) * S(0.125);
  const S fifth = (twist - three * (slope - rise)) * S(0.125);
  const S second = bend * half - S(2) * fourth, third = (slope - rise) * half - S(2) * fifth;
  return {mean - second - fourth, rise - third - fifth, second, third, fourth, fifth};
}

/// Evaluates a polynomial by Horner's rule.
template <class S>
S value_at(const Quintic<S>& c, const S& s) {
  S sum = c.back();
  for (int k = 5; k-- > 0;) sum = sum * s + c[k];
  return sum;
}

/// Returns the derivative of a polynomial with respect to s.
template <class S>
Quintic<S> derivative(const Quintic<S>& c) {
  Quintic<S> result{};
  for (int k = 1; k <= 5; ++k) result[k - 1] = S(k) * c[k];
  return result;
}

}  // namespace desmo
