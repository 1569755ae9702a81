// Every constraint kind against derivatives that share no code with it: the complex step, which
// has no truncation and no cancellation.

#include "cases/constraints.h"

#include <gtest/gtest.h>

#include <complex>
#include <random>
#include <set>
#include <vector>

namespace desmo {
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

template <std::size_t N>
std::array<const Complex*, N> pointers(const std::array<std::vector<Complex>, N>& x) {
  std::array<const Complex*, N> p;
  for (std::size_t k = 0; k < N; ++k) p[k] = x[k].data();
  return p;
}

template <class Kind>
std::vector<Complex> residual(const Setup<Kind>& s) {
  std::vector<Complex> phi(Kind::rows);
  Kind::residual(pointers(s.q).data(), s.c.data(), phi.data());
  return phi;
}

/// Φ_q as a dense table [row][operand][component], zero where no entry is emitted.
template <class Kind>
auto jacobian(const Setup<Kind>& s) {
  std::array<std::array<std::array<Complex, 3>, Setup<Kind>::operands>, Kind::rows> table{};
  std::set<std::array<int, 3>> seen;
  int entries = 0;
  Kind::jacobian(pointers(s.q).data(), s.c.data(), [&](int r, int k, int i, Complex value) {
    EXPECT_TRUE(seen.insert({r, k, i}).second) << "the entry is emitted twice";
    table[r][k][i] = value;
    ++entries;
  });
  EXPECT_EQ(entries, Kind::entries);
  return table;
}

template <class Kind>
class ConstraintKind : public testing::Test {};

template <class Tuple>
struct TypesOf;
template <class... Kinds>
struct TypesOf<std::tuple<Kinds...>> {
  using type = testing::Types<Kinds...>;
};
TYPED_TEST_SUITE(ConstraintKind, TypesOf<ConstraintKinds>::type);

TYPED_TEST(ConstraintKind, JacobianIsTheDerivativeOfTheResidual) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    Setup<TypeParam> s(seed);
    const auto table = jacobian(s);
    for (int k = 0; k < s.operands; ++k)
      for (std::size_t i = 0; i < s.q[k].size(); ++i) {
        Setup<TypeParam> stepped = s;
        stepped.q[k][i] += Complex(0, h);
        const auto phi = residual(stepped);
        for (int r = 0; r < TypeParam::rows; ++r)
          EXPECT_NEAR(table[r][k][i].real(), phi[r].imag() / h, 1e-14)
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
    const auto table = jacobian(stepped);
    for (int r = 0; r < TypeParam::rows; ++r) {
      double expected = 0;
      for (int k = 0; k < s.operands; ++k)
        for (std::size_t i = 0; i < s.q[k].size(); ++i)
          expected += table[r][k][i].imag() / h * s.v[k][i].real();
      EXPECT_NEAR(gamma[r].real(), expected, 1e-13) << "row " << r;
    }
  }
}

TYPED_TEST(ConstraintKind, LinearMeansThatTheJacobianIsConstant) {
  Setup<TypeParam> a(1), b(2);
  b.c = a.c;
  EXPECT_EQ(jacobian(a) == jacobian(b), TypeParam::linear);
}

TEST(ConstraintKinds, HaveDistinctNames) {
  std::set<std::string_view> names;
  for (int kind = 0; kind < constraint_kind_count; ++kind)
    visit_kind(kind, [&](auto k) { EXPECT_TRUE(names.insert(k.name).second) << k.name; });
  EXPECT_EQ(names.size(), static_cast<std::size_t>(constraint_kind_count));
}

}  // namespace
}  // namespace desmo
