// Jets against difference quotients in quadruple precision, and sums and products exactly.

#include "formulations/constraints/jet.h"

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/float128.hpp>
#include <vector>

namespace desmo::jet_test {
namespace {

using Wide = boost::multiprecision::float128;

/// Expects derivatives of f(a(t), b(t)) at t = 0, for polynomials a and b of degree two.
template <class Function>
void expect_derivatives(Function&& f) {
  const std::array<Wide, 3> a{0.7, -1.3, 0.9}, b{-0.4, 2.1, 1.7};  // a(t) = a₀ + a₁ t + a₂ t²/2
  const auto at = [&](const Wide& t) {
    const auto polynomial = [&](const std::array<Wide, 3>& c) {
      return Wide(c[0] + c[1] * t + c[2] * t * t / 2);
    };
    return Wide(f(polynomial(a), polynomial(b)));
  };
  const Wide h = 0x1p-24;
  const Jet<Wide> found = f(Jet<Wide>(a[0], a[1], a[2]), Jet<Wide>(b[0], b[1], b[2]));
  EXPECT_EQ(found.value, at(0));
  EXPECT_LT(abs(found.first - (at(h) - at(-h)) / (2 * h)), 1e-12);
  EXPECT_LT(abs(found.second - (at(h) - 2 * at(0) + at(-h)) / (h * h)), 1e-12);
}

TEST(Jet, HasTheDerivativesOfEachOperation) {
  expect_derivatives([](auto a, auto) { return decltype(a)(-a); });
  expect_derivatives([](auto a, auto b) { return decltype(a)(a + b); });
  expect_derivatives([](auto a, auto b) { return decltype(a)(a - b); });
  expect_derivatives([](auto a, auto b) { return decltype(a)(a * b); });
  expect_derivatives([](auto a, auto) { return decltype(a)(sin(a)); });
  expect_derivatives([](auto a, auto) { return decltype(a)(cos(a)); });
  expect_derivatives([](auto a, auto b) { return decltype(a)(sin(a * b) * b - cos(b + a * a)); });
}

}  // namespace
}  // namespace desmo::jet_test
