// Meanings of the constraint kinds, in configurations whose residual is known.

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "tests/cases/operands.h"

namespace desmo::constraint_meanings_test {
namespace {

using Vec = std::vector<double>;

/// Φ of a kind in a configuration, within rounding.
template <class Kind>
void expect_residual(const std::array<Vec, Kind::operand_sizes.size()>& q, Vec c,
                     const Vec& expected) {
  ASSERT_EQ(c.size(), static_cast<std::size_t>(Kind::constants));
  ASSERT_EQ(expected.size(), static_cast<std::size_t>(Kind::rows));
  for (std::size_t k = 0; k < q.size(); ++k)
    ASSERT_EQ(q[k].size(), static_cast<std::size_t>(Kind::operand_sizes[k]));
  c.push_back(0);  // never read; data() must not be null
  Vec phi(Kind::rows);
  Kind::residual(pointers(q).data(), c.data(), phi.data());
  for (int r = 0; r < Kind::rows; ++r)
    EXPECT_NEAR(phi[r], expected[r], 1e-14) << Kind::name << ", row " << r;
}

const double pi = std::numbers::pi;
const double right = pi / 2;

TEST(Meaning, OfPlainKinds) {
  expect_residual<Unit<2>>({{{0.6, -0.8}}}, {}, {0});
  expect_residual<Unit<2>>({{{3, 4}}}, {}, {24});
  expect_residual<Rigid<2, 0>>({{{1, 2}, {1, 2}}}, {}, {0, 0});
  expect_residual<Rigid<2, 0>>({{{1, 2}, {4, 1}}}, {}, {-3, 1});
  expect_residual<Rigid<2, 1>>({{{7, 2}, {1, 2}, {3, 0}}}, {2}, {0, 0});
  expect_residual<Rigid<2, 1>>({{{7, 2}, {1, 2}, {3, 1}}}, {1}, {3, -1});
  expect_residual<Along<2>>({{{1, 2}, {4, 6}, {0.6, 0.8}, {5}}}, {}, {0, 0});
  expect_residual<Along<2>>({{{1, 2}, {4, 6}, {0.6, 0.8}, {10}}}, {}, {-3, -4});
  expect_residual<Component<2, 0>>({{{3, 4}, {3}}}, {}, {0});
  expect_residual<Component<2, 1>>({{{3, 4}, {3}}}, {}, {1});
  expect_residual<Component<3, 0>>({{{3, 4, 5}, {3}}}, {}, {0});
  expect_residual<Component<3, 1>>({{{3, 4, 5}, {3}}}, {}, {1});
  expect_residual<Distance<2>>({{{1, 1}, {4, 5}, {5}}}, {}, {0});
  expect_residual<Distance<2>>({{{1, 1}, {4, 5}, {4}}}, {}, {9});
  expect_residual<Distance<3>>({{{1, 1, 1}, {2, 3, 3}, {3}}}, {}, {0});
  expect_residual<Distance<3>>({{{1, 1, 1}, {2, 3, 3}, {1}}}, {}, {8});
  expect_residual<PlanarDirection>({{{0, 1}, {right}}}, {}, {0, 0});
  expect_residual<PlanarDirection>({{{-1, 0}, {pi}}}, {}, {0, 0});
  expect_residual<PlanarDirection>({{{0, 1}, {-right}}}, {}, {0, 2});
  expect_residual<Reach<2>>({{{1, 2}, {4, 6}, {0.6, 0.8}, {5}}}, {}, {0});
  expect_residual<Reach<2>>({{{1, 2}, {4, 6}, {-0.6, -0.8}, {5}}}, {}, {-10});
  expect_residual<Reach<3>>({{{1, 2, 3}, {1, 2, 7}, {0, 0, 1}, {3}}}, {}, {1});
}

TEST(Meaning, OfCombinations) {
  const Vec x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, d{1, 1, 1};
  expect_residual<Combination<3, 1>>({{{-2, 0, 0}, x}}, {-2}, {0, 0, 0});
  expect_residual<Combination<3, 2>>({{{3, 5, 0}, x, y}}, {3, 5}, {0, 0, 0});
  expect_residual<Combination<3, 3>>({{{3, 5, 7}, x, y, z}}, {3, 5, 7}, {0, 0, 0});
  expect_residual<Combination<3, 4>>({{{3, 5, 7}, x, y, z, d}}, {2, 4, 6, 1}, {0, 0, 0});
  expect_residual<Combination<3, 2>>({{{3, 5, 1}, x, y}}, {2, 3}, {1, 2, 1});
}

TEST(Meaning, OfPlanarRelations) {
  // Let d = (3, 1). Then J d = (−1, 3), and 2 d + J d = (5, 5).
  // To the right of d instead of to the left, it is off by 2 J d.
  const Vec a{10, 20}, d{3, 1}, b{13, 21}, left{2, 1}, right_of_d{2, -1};
  for (const auto& [c, off] : {std::pair(left, Vec{0, 0}), {right_of_d, Vec{-2, 6}}}) {
    expect_residual<PlanarRelation<PlanarTarget::point, DirectionOf::vector>>({{{15, 25}, a, d}}, c,
                                                                              off);
    expect_residual<PlanarRelation<PlanarTarget::point, DirectionOf::line>>({{{15, 25}, a, b}}, c,
                                                                            off);
    expect_residual<PlanarRelation<PlanarTarget::vector, DirectionOf::vector>>({{{5, 5}, d}}, c,
                                                                               off);
    expect_residual<PlanarRelation<PlanarTarget::vector, DirectionOf::line>>({{{5, 5}, a, b}}, c,
                                                                             off);
  }
}

TEST(Meaning, OfAnOffsetIsTheDistanceToTheLeftOfTheLine) {
  const Vec u{0.6, 0.8}, o{1, 1};
  expect_residual<Offset>({{u, o, {1 + 3, 1 + 4}}}, {0}, {0});               // on the line
  expect_residual<Offset>({{u, o, {1 + 3 - 1.6, 1 + 4 + 1.2}}}, {2}, {0});   // to the left
  expect_residual<Offset>({{u, o, {1 + 3 + 1.6, 1 + 4 - 1.2}}}, {2}, {-4});  // to the right
}

TEST(Meaning, OfAPlanarTurnIsTheAngleCounterClockwise) {
  // e = (2, 1) turned by π/2 and stretched by 3 is d = (−3, 6).
  // The other way round it would be −d.
  const Vec d{-3, 6}, e{2, 1}, a{1, 1}, b{-2, 7}, p{5, 5}, q{7, 6};
  for (const auto& [turn, off] : {std::pair(Vec{right}, Vec{0, 0}), {Vec{-right}, Vec{-6, 12}}}) {
    expect_residual<PlanarTurn<Between::vector_and_vector>>({{d, e, turn}}, {3}, off);
    expect_residual<PlanarTurn<Between::vector_and_line>>({{d, p, q, turn}}, {3}, off);
    expect_residual<PlanarTurn<Between::line_and_vector>>({{a, b, e, turn}}, {3}, off);
    expect_residual<PlanarTurn<Between::line_and_line>>({{a, b, p, q, turn}}, {3}, off);
    expect_residual<PlanarTurn<Between::lines_at_point>>({{p, {2, 11}, q, turn}}, {3}, off);
  }
}

/// The derivative of Φ by an angle, the last operand of its kind: negative where it is the one
/// meant.
template <class Kind>
double derivative_by_angle(const std::array<Vec, Kind::operand_sizes.size()>& q, const Vec& c) {
  double derivative = 0;
  Kind::jacobian(pointers(q).data(), c.data(), [&](int, std::size_t operand, int, double value) {
    if (operand + 1 == q.size()) derivative = value;
  });
  return derivative;
}

/// A direction d and whatever it is measured from, with d at this angle.
template <class Kind>
void expect_modulo_pi(std::array<Vec, Kind::operand_sizes.size()> q, const Vec& c, double angle) {
  q.back() = {angle};
  expect_residual<Kind>(q, c, {0});
  EXPECT_LT(derivative_by_angle<Kind>(q, c), -0.1) << Kind::name;
  q.back() = {angle + pi};
  expect_residual<Kind>(q, c, {0});
  EXPECT_GT(derivative_by_angle<Kind>(q, c), 0.1) << Kind::name;
}

TEST(Meaning, OfABearingIsAnAngleModuloPi) {
  const Vec a{1, 1}, after_a{1 - 2, 1}, up{0, 1}, none{0};
  expect_modulo_pi<PlanarBearing<DirectionOf::vector>>({{up, none}}, {}, right);
  expect_modulo_pi<PlanarBearing<DirectionOf::line>>({{a, after_a, none}}, {}, pi);
  expect_residual<PlanarBearing<DirectionOf::line>>({{a, after_a, {right}}}, {}, {2});

  // As in PlanarTurn: e = (2, 1)/10 turned by π/2 and stretched by 3 is d = (−3, 6)/10.
  const Vec d{-0.3, 0.6}, e{0.2, 0.1}, b{0.7, 1.6}, p{0, 0}, q{0.2, 0.1}, end{-0.3, 0.6};
  expect_modulo_pi<PlanarBearingFrom<Between::vector_and_vector>>({{d, e, none}}, {3}, right);
  expect_modulo_pi<PlanarBearingFrom<Between::vector_and_line>>({{d, p, q, none}}, {3}, right);
  expect_modulo_pi<PlanarBearingFrom<Between::line_and_vector>>({{a, b, e, none}}, {3}, right);
  expect_modulo_pi<PlanarBearingFrom<Between::line_and_line>>({{a, b, p, q, none}}, {3}, right);
  expect_modulo_pi<PlanarBearingFrom<Between::lines_at_point>>({{p, end, q, none}}, {3}, right);
  expect_modulo_pi<PlanarBearingFrom<Between::lines_at_point>>({{p, end, q, none}}, {-3}, -right);
  expect_residual<PlanarBearingFrom<Between::vector_and_vector>>({{d, e, {0}}}, {3}, {0.45});
}

TEST(Meaning, OfAFrameAngle) {
  const Vec x{0, 1, 0}, z{0, 0, 1}, a{1, 2, 3};
  const double angle = 0.4, cosine = std::cos(angle), sine = std::sin(angle);
  // A direction of length 2 at this angle from x towards z, out of their plane by 5; and from −x.
  const Vec from_x{5, 2 * cosine, 2 * sine}, from_minus_x{5, -2 * cosine, 2 * sine};
  const auto after = [&](const Vec& w) { return Vec{a[0] + w[0], a[1] + w[1], a[2] + w[2]}; };
  for (const double missing : {0.0, 0.1}) {
    const Vec given{angle - missing}, off{2 * std::sin(missing)};
    expect_residual<FrameAngle<1, DirectionOf::vector>>({{x, z, from_x, given}}, {}, off);
    expect_residual<FrameAngle<1, DirectionOf::line>>({{x, z, a, after(from_x), given}}, {}, off);
    expect_residual<FrameAngle<-1, DirectionOf::vector>>({{x, z, from_minus_x, given}}, {}, off);
    expect_residual<FrameAngle<-1, DirectionOf::line>>({{x, z, a, after(from_minus_x), given}}, {},
                                                       off);
  }
  expect_modulo_pi<FrameAngle<1, DirectionOf::vector>>({{x, z, from_x, {}}}, {}, angle);
  expect_modulo_pi<FrameAngle<-1, DirectionOf::line>>({{x, z, a, after(from_minus_x), {}}}, {},
                                                      angle);
}

}  // namespace
}  // namespace desmo::constraint_meanings_test
