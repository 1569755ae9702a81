// The quadruple reference: two formulations that share nothing but residuals agree to 1e-25, and
// both are what a closed form says.

#include "formulations/verification/reference/reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cases/extremes/rows.h"
#include "formulations/motion/groupwise/groupwise_solver.h"
#include "formulations/verification/reference/wide_instant.h"
#include "tests/accuracy/scenes.h"
#include "tests/library/jet.h"

namespace desmo::reference_test {
namespace {

constexpr double agreement = 1e-25;

void expect_agreement(const Model& m, const TimeGrid& grid, int instants) {
  const std::vector<double> times = sampled(grid, instants);
  const Reference r = make_reference(m, times);
  ASSERT_EQ(r.instants.size(), times.size());
  for (const Level level : all_levels) {
    EXPECT_LE(r.floor[level], agreement) << m.name << ", level " << static_cast<int>(level);
    EXPECT_GT(r.floor[level], 0) << "they round alike: are they the same?";
  }
}

class ReferenceOfCase : public testing::TestWithParam<std::pair<const Case*, int>> {};

TEST_P(ReferenceOfCase, TwoFormulationsAgreeOverTheMotion) {
  const auto [definition, coordinates] = GetParam();
  const Scene scene = make_scene(*definition, coordinates);
  expect_agreement(make_model(scene), time_grid(DESMO_TEST_SECONDS, 0.05), 16);
}

std::vector<std::pair<const Case*, int>> ends_of_sizes() {
  std::vector<std::pair<const Case*, int>> result;
  for (const Case& c : cases())
    for (const int n : {c.sizes.front(), c.sizes.back()}) result.emplace_back(&c, n);
  return result;
}

INSTANTIATE_TEST_SUITE_P(Cases, ReferenceOfCase, testing::ValuesIn(ends_of_sizes()),
                         [](const auto& info) {
                           return std::string(info.param.first->name) + "_" +
                                  std::to_string(info.param.second);
                         });

TEST(Reference, TwoFormulationsAgreeOnTheLibrary) {
  for (const Scene& scene : library_scenes()) expect_agreement(make_model(scene), scene.grid, 16);
}

TEST(Reference, TwoFormulationsAgreeWhateverTheUnit) {
  for (const double factor : {1e-9, 1e9}) {
    const Scene scene = enlarged(library_scene("slider_crank"), factor);
    expect_agreement(make_model(scene), scene.grid, 9);
  }
}

/// A four-bar of bars 1, 3 and 4 on a base of 5.99, drawn with its crank at 180°, nearly stretched:
/// Newton's method leads from there to the other branch at 2.5 rad.
TEST(Reference, StartsOnTheBranchOfTheDrawing) {
  const double base = 5.99, begins = 2.5;
  const DyadChain chain = extremes::one_dyad(1, std::numbers::pi, base, 3, 4);
  for (const double turns : {0, 1, -2}) {
    const double angle = begins + turns * 2 * std::numbers::pi;
    const Model m =
        make_model(extremes::case_of("", {chain}, {Polynomial{{angle, 1}}}, {0, 0.1, 2}).scene);
    const double x = base - std::cos(begins), y = -std::sin(begins), length = std::hypot(x, y);
    const double along = (length * length + 9 - 16) / (2 * length);
    const double c =
        std::sin(begins) + (along * y + std::sqrt(9 - along * along) * x) / length;  // 1.127
    const std::vector<double> times{0, 0.1};
    const Reference r = make_reference(m, times);
    EXPECT_LE(r.floor.position, agreement);
    EXPECT_NEAR(m.value("dyad1/C.y", r.instants[0].q), c, 1e-12) << turns;
    const auto standard = reference_solution(m, times, Precision::standard);
    EXPECT_NEAR(m.value("dyad1/C.y", standard[0].q), c, 1e-12) << turns;
    EXPECT_EQ(standard[0].q[m.coordinate("crank/theta")], angle);
  }
}

TEST(Reference, ADifferenceOfOneOutputShowsInTheFloor) {
  const Model m = make_model(library_scene("slider_crank"));
  const std::vector<Quadruple> any(m.coordinates(), Quadruple(1) / 3);
  const WideInstant a{0.1, any, any, any};
  WideInstant b = a;
  const Scales scales{{2, 3, 5}, {1, 7, 11}};
  const Entity& s = m.entities[m.find("s")];
  const Entity& phi = m.entities[m.find("phi")];
  b.q[s.first] += 1e-22;
  b.qd[phi.first] += 1e-22;
  b.qdd[s.first] += 1e-22;
  const PerLevel<double> d = disagreement(m, std::span(&a, 1), std::span(&b, 1), scales);
  EXPECT_NEAR(d.position, 1e-22 / 2, 1e-26);
  EXPECT_NEAR(d.velocity, 1e-22 / 7, 1e-26);
  EXPECT_NEAR(d.acceleration, 1e-22 / 5, 1e-26);
}

TEST(Reference, NoticesACorrectionThatIsNoNumber) {
  for (const Case& c : cases()) {
    const Model m = make_model(make_scene(c, c.sizes.front()));
    GroupwiseSolver<double> groups(m);
    for (const PartDefinition& part : make_partition(m, Partition::group)) {
      std::vector<double> q = m.estimate;
      q[part.unknowns.front()] = NAN;
      groups.place(q);
      EXPECT_TRUE(std::isnan(groups.correct_positions())) << c.name;
    }
  }
}

TEST(Reference, KeepsWhatRoundingLeft) {
  const Model m = make_model(library_scene("slider_crank"));
  const auto r = reference_solution(m, std::vector{0.0, 0.1}, Precision::quadruple)[1];
  double largest = 0;
  for (std::size_t i = 0; i < r.q.size(); ++i) {
    EXPECT_EQ(r.q[i] + r.remainder.q[i], r.q[i]) << "not the nearest double";
    largest = std::max(largest, std::abs(r.remainder.q[i]));
  }
  EXPECT_GT(largest, 1e-18);
  EXPECT_TRUE(reference_solution(m, std::vector{0.0}, Precision::standard)[0].remainder.q.empty());
}

// ——— A closed form, evaluated in quadruple precision ———

using WideJet = exact::BasicJet<Quadruple>;

/// A coordinate with all digits the reference has, at each level.
WideJet found(const ReferenceInstant& r, const Model& m, const std::string& name, int i = 0) {
  const int at = m.entities[m.find(name)].first + i;
  return {Quadruple(r.q[at]) + r.remainder.q[at], Quadruple(r.qd[at]) + r.remainder.qd[at],
          Quadruple(r.qdd[at]) + r.remainder.qdd[at]};
}

void expect_near(const WideJet& a, const WideJet& b, const std::string& what) {
  EXPECT_LT(abs(a.v - b.v), 1e-30 * std::max(1.0, static_cast<double>(abs(b.v)))) << what;
  EXPECT_LT(abs(a.d - b.d), 1e-30 * std::max(1.0, static_cast<double>(abs(b.d)))) << what;
  EXPECT_LT(abs(a.dd - b.dd), 1e-30 * std::max(1.0, static_cast<double>(abs(b.dd)))) << what;
}

/// The angle that drives: c₀ + c₁ t.
WideJet driven(const Model& m, double t) {
  const std::vector<Derived>& c = std::get<Polynomial>(m.drivers[0].motion).coefficients;
  const auto exact = [&](std::size_t i) { return WideJet(as<Quadruple>(c[i])); };
  return exact(0) + exact(1) * WideJet::time(t);
}

/// The constant of the only constraint with these operands: a length as the file means it.
Quadruple constant(const Model& m, const std::vector<EntityId>& operands) {
  for (const Constraint& c : m.constraints)
    if (c.operands == operands) return as<Quadruple>(c.constants[0]);
  throw std::invalid_argument("no such constraint");
}

TEST(Reference, IsTheClosedFormOfTheSliderCrank) {
  const Model m = make_model(library_scene("slider_crank"));
  const EntityId A = m.find("A"), B = m.find("B"), C = m.find("C");
  const WideJet crank(constant(m, {A, B, m.find("theta")}));
  const WideJet rod(constant(m, {B, C, m.find("phi")}));
  const std::vector<double> times{0, 0.05, 0.3, 0.77, 1};
  const Reference reference = make_reference(m, times);
  for (const ReferenceInstant& r : reference.instants) {
    const WideJet theta = driven(m, r.time), x = crank * cos(theta), y = crank * sin(theta);
    const WideJet s = x + sqrt(rod * rod - y * y);
    const std::string at = " at " + std::to_string(r.time);
    expect_near(found(r, m, "B", 0), x, "B x" + at);
    expect_near(found(r, m, "B", 1), y, "B y" + at);
    expect_near(found(r, m, "C", 0), s, "C x" + at);
    expect_near(found(r, m, "C", 1), WideJet(0), "C y" + at);
    expect_near(found(r, m, "s"), s, "s" + at);
    expect_near(found(r, m, "phi"), atan2(-y, s - x), "phi" + at);
  }
}

}  // namespace
}  // namespace desmo::reference_test
