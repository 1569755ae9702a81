// Every constraint kind against derivatives that share no code with it: the complex step, which
// has no truncation and no cancellation.

#include "formulations/constraints/constraints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <complex>
#include <random>
#include <set>
#include <string_view>
#include <vector>

#include "formulations/model/model.h"
#include "tests/cases/operands.h"

namespace desmo::constraints_test {
namespace {

using Complex = std::complex<double>;
constexpr double h = 1e-50;

/// Random positions, velocities and dimensions for a kind.
template <class Kind>
struct Setup {
  static constexpr int operands = Kind::operand_sizes.size();

  explicit Setup(unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(-2, 2);
    for (int k = 0; k < operands; ++k)
      for (int i = 0; i < Kind::operand_sizes[k]; ++i) {
        q[k].push_back(uniform(generator));
        v[k].push_back(uniform(generator));
      }
    for (int i = 0; i < Kind::constants; ++i) c.push_back(uniform(generator));
    c.push_back(0);  // never read; data() must not be null
  }

  std::array<std::vector<Complex>, operands> q, v;
  std::vector<Complex> c;
};

template <class Kind>
[[gnu::noinline]] std::vector<Complex> residual(const Setup<Kind>& s) {
  std::vector<Complex> phi(Kind::rows);
  Kind::residual(pointers(s.q).data(), s.c.data(), phi.data());
  return phi;
}

/// Entries of Φ_q in the order in which a kind emits them. All kinds call one function, which is
/// not inlined: they emit a thousand entries, and each would be compiled with checks of its own.
class Emitted {
 public:
  [[gnu::noinline]] void operator()(int row, int operand, int component, Complex value) {
    places.push_back({row, operand, component});
    values.push_back(value);
  }

  /// ∂Φ_row of a component; zero where no entry is emitted.
  Complex at(int row, int operand, int component) const {
    const auto it = std::ranges::find(places, std::array{row, operand, component});
    return it == places.end() ? Complex(0) : values[it - places.begin()];
  }

  std::vector<std::array<int, 3>> places;
  std::vector<Complex> values;
};

template <class Kind>
[[gnu::noinline]] Emitted jacobian(const Setup<Kind>& s) {
  Emitted emitted;
  Kind::jacobian(pointers(s.q).data(), s.c.data(), emitted);
  return emitted;
}

template <class Kind>
class ConstraintKind : public testing::Test {};
TYPED_TEST_SUITE(ConstraintKind, EveryKind);

TYPED_TEST(ConstraintKind, JacobianIsTheDerivativeOfTheResidual) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    Setup<TypeParam> s(seed);
    const Emitted table = jacobian(s);
    for (int k = 0; k < s.operands; ++k)
      for (std::size_t i = 0; i < s.q[k].size(); ++i) {
        Setup<TypeParam> stepped = s;
        stepped.q[k][i] += Complex(0, h);
        const auto phi = residual(stepped);
        for (int r = 0; r < TypeParam::rows; ++r)
          EXPECT_NEAR(table.at(r, k, static_cast<int>(i)).real(), phi[r].imag() / h, 1e-14)
              << "row " << r << " operand " << k << " component " << i;
      }
  }
}

TYPED_TEST(ConstraintKind, QuadraticTermIsTheDerivativeOfTheJacobian) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    Setup<TypeParam> s(seed);
    std::vector<Complex> gamma(TypeParam::rows);
    TypeParam::quadratic(pointers(s.q).data(), pointers(s.v).data(), s.c.data(), gamma.data());

    Setup<TypeParam> stepped = s;  // along the velocity
    for (int k = 0; k < s.operands; ++k)
      for (std::size_t i = 0; i < s.q[k].size(); ++i) stepped.q[k][i] += Complex(0, h) * s.v[k][i];
    const Emitted table = jacobian(stepped);
    for (int r = 0; r < TypeParam::rows; ++r) {
      double expected = 0;
      for (int k = 0; k < s.operands; ++k)
        for (std::size_t i = 0; i < s.q[k].size(); ++i)
          expected += table.at(r, k, static_cast<int>(i)).imag() / h * s.v[k][i].real();
      EXPECT_NEAR(gamma[r].real(), expected, 1e-13) << "row " << r;
    }
  }
}

TYPED_TEST(ConstraintKind, LinearMeansThatTheJacobianIsConstantAndReadsNoState) {
  Setup<TypeParam> a(1), b(2);
  b.c = a.c;
  EXPECT_EQ(jacobian(a).values == jacobian(b).values, TypeParam::linear);
  if constexpr (TypeParam::linear) {
    const std::array<const Complex*, Setup<TypeParam>::operands> none{};
    Emitted emitted;
    TypeParam::jacobian(none.data(), a.c.data(), emitted);
    EXPECT_EQ(emitted.values, jacobian(a).values);

    std::vector<Complex> gamma(TypeParam::rows, Complex(1));
    TypeParam::quadratic(pointers(a.q).data(), pointers(a.v).data(), a.c.data(), gamma.data());
    for (const Complex& value : gamma) EXPECT_EQ(value, Complex(0));
  }
}

TYPED_TEST(ConstraintKind, EmitsItsEntriesOnceAndInTheSameOrder) {
  const auto places = jacobian(Setup<TypeParam>(2)).places;
  EXPECT_EQ(places.size(), static_cast<std::size_t>(TypeParam::entries));
  EXPECT_EQ(std::set(places.begin(), places.end()).size(), places.size());
  for (const auto& [row, operand, component] : places) {
    EXPECT_TRUE(row >= 0 && row < TypeParam::rows);
    EXPECT_TRUE(component >= 0 && component < TypeParam::operand_sizes[operand]);
  }
  Setup<TypeParam> nothing(1);
  for (auto& x : nothing.q) std::ranges::fill(x, Complex(0));
  std::ranges::fill(nothing.c, Complex(0));
  EXPECT_EQ(places, jacobian(nothing).places);
}

TEST(ConstraintKinds, HaveDistinctNames) {
  std::set<std::string_view> names;
  for (int kind = 0; kind < constraint_kind_count; ++kind)
    EXPECT_TRUE(names.insert(constraint_kind_name(kind)).second) << constraint_kind_name(kind);
  EXPECT_EQ(constraint_kind_name(kind_index<Distance<2>>()), "distance2");
  EXPECT_THROW(constraint_kind_name(-1), std::out_of_range);
  EXPECT_THROW(constraint_kind_name(constraint_kind_count), std::out_of_range);
  EXPECT_EQ(names.size(), static_cast<std::size_t>(constraint_kind_count));
}

}  // namespace
}  // namespace desmo::constraints_test
