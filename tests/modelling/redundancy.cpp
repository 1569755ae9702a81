// Equations that depend on others: redundant mechanisms, and positions that deceive.

#include <gtest/gtest.h>

#include <set>

#include "tests/modelling/common.h"
#include "tests/overconstrained.h"

namespace desmo::redundancy_test {
namespace {

TEST(Redundant, ParallelogramWithThreeCranksIsAcceptedAndReported) {
  const Mechanism mechanism = parallelogram({0, 2, 5});
  const ModellingResult modelled = model_mechanism(mechanism, turning);
  const Model& m = modelled.model;
  EXPECT_EQ(m.structural_groups(), 1);
  EXPECT_EQ(m.groups[0].bodies,
            (std::vector<std::string>{"crank1", "crank2", "crank3", "coupler"}));
  // The first crank's length defines nothing new; one equation of the others is too many.
  ASSERT_EQ(modelled.left_out.size(), 2u);
  std::set<std::string> concerned;
  for (const LeftOut& l : modelled.left_out) {
    EXPECT_TRUE(l.redundant) << l.equation;
    EXPECT_FALSE(l.follows_from.empty()) << l.equation;
    concerned.insert(l.equation);
    for (const std::string& source : l.follows_from) {
      EXPECT_TRUE(std::ranges::any_of(m.constraints, [&](const Constraint& c) {
        return c.name == source;
      })) << source;
      EXPECT_NE(source, l.equation);
    }
  }
  EXPECT_EQ(concerned.size(), 2u);

  const std::vector<double> times = instants(1.5);
  for (const char* id : {"global_automatic_lapack", "global_automatic_eigen", "group_automatic_klu",
                         "block_automatic_eigen"}) {
    const Solved s(m, times, id);
    for (int k = 0; k < s.instants() && !HasFailure(); ++k) {
      const double theta = 1 + times[k];
      const double pivots[] = {0, 2, 5};
      for (int i = 0; i < 3; ++i) {
        const std::string end = "C" + std::to_string(i + 1);
        const Vec spoke = polar(1, theta), rim = polar(1, theta + std::numbers::pi / 2);
        expect_near(s.position(k, end), Vec{pivots[i], 0, 0} + spoke, 1e-12, end);
        expect_near(s.velocity(k, end), rim, 1e-12, end + " velocity");
        expect_near(s.acceleration(k, end), -1.0 * spoke, 1e-12, end + " acceleration");
      }
    }
  }
}

TEST(Redundant, PlanarFourBarInSpaceWithParallelAxesIsAccepted) {
  const Mechanism mechanism = spatial_four_bar();
  const ModellingResult modelled = model_mechanism(mechanism, turning);
  EXPECT_TRUE(std::ranges::any_of(modelled.left_out, &LeftOut::redundant));
  const std::vector<double> times = instants(1.5);
  for (const char* id :
       {"global_automatic_eigen", "group_automatic_klu", "block_automatic_lapack"}) {
    const Solved s(modelled.model, times, id);
    const auto nominal = [&](const char* name) {
      return std::ranges::find(mechanism.points, name, &Mechanism::Point::name)->position;
    };
    for (int k = 0; k < s.instants() && !HasFailure(); ++k) {
      const Vec b = s.position(k, "B"), c = s.position(k, "C");
      expect_near(b, polar(1, 1 + times[k]), 1e-12, "B");
      EXPECT_NEAR(norm(c - b), norm(nominal("C") - nominal("B")), 1e-12);
      EXPECT_NEAR(norm(c - nominal("D")), norm(nominal("C") - nominal("D")), 1e-12);
      EXPECT_NEAR(c[2], 0, 1e-12);
    }
  }
}

/// Linkages that close to six digits of their file leave out as many equations as exact ones.
TEST(Redundant, LinkagesTypedWithFewDigitsKeepTheSameEquations) {
  const auto kept = [](const Scene& scene) {
    int count = 0;
    try {
      for (const Constraint& c : make_model(scene).constraints) count += kept_rows(c);
    } catch (const std::invalid_argument& error) {
      ADD_FAILURE() << error.what();
    }
    return count;
  };
  for (const long double start : {0.83L, 1.24L, 1.65L, 2.06L})
    for (const int digits : {12, 9, 8, 7, 6}) {
      EXPECT_EQ(kept(bennett(start, digits)), kept(bennett(start, 17)))
          << digits << ' ' << static_cast<double>(start);
      for (const bool stated : {true, false})
        EXPECT_EQ(kept(parallel_cranks(start, digits, stated)),
                  kept(parallel_cranks(start, 17, stated)))
            << digits << ' ' << stated << ' ' << static_cast<double>(start);
    }
}

// ---- a special position deceives ----

TEST(SpecialPosition, FoldedFourBarKeepsAllItsEquations) {
  // Drawn with all links on one line, a change point of the parallelogram: its coupler and its
  // second crank restrict the same direction there, and there only.
  const ModellingResult folded = model_mechanism(parallelogram({0, 2}, 0), {Polynomial{{0, 1}}});
  const ModellingResult open = model_mechanism(parallelogram({0, 2}, 1), {Polynomial{{0, 1}}});
  for (GroupId g = 0; g < 2; ++g) {
    std::vector<Stated> expected = equations_of(open.model, g);
    expect_equations(folded.model, g, expected);
  }
  EXPECT_EQ(folded.left_out.size(), open.left_out.size());
}

TEST(SpecialPosition, CrankRockerAtItsDeadPointKeepsAllItsEquations) {
  // Crank 1, coupler 3, rocker 3, base 4 with crank and coupler in line: C is at 4 from A, and the
  // rocker, driven, cannot tell the crank's velocity in this position.
  const auto describe_at_dead_point = [](bool driven_by_rocker) {
    Sketch d("dead point", 2);
    const int A = d.ground_point("A", {0, 0, 0}), D = d.ground_point("D", {4, 0, 0});
    const double angle = 2 * std::asin(3.0 / 8);  // isosceles: A-C = A-D = 4, C-D = 3
    const int B = d.point("B", polar(1, angle)), C = d.point("C", polar(4, angle));
    d.bodies({{"crank", {A, B}}, {"coupler", {B, C}}, {"rocker", {D, C}}});
    d.angle("theta", line(A, B)).driven = !driven_by_rocker;
    d.angle("psi", line(D, C)).driven = driven_by_rocker;
    return d.release_pinned();
  };
  const double start = 2 * std::asin(3.0 / 8);
  const Model by_crank =
      model_mechanism(describe_at_dead_point(false), {Polynomial{{start, 1}}}).model;
  expect_equations(by_crank, 0, {{"planar_angle", {"A", "B", "theta"}, {1}}});
  expect_equations(by_crank, 1,
                   {{"length2", {"B", "C"}, {9}}, {"planar_angle", {"D", "C", "psi"}, {3}}});
  const Model by_rocker =
      model_mechanism(describe_at_dead_point(true), {Polynomial{{1.0, 1}}}).model;
  expect_equations(by_rocker, 0, {{"planar_angle", {"D", "C", "psi"}, {3}}});
  expect_equations(by_rocker, 1,
                   {{"length2", {"B", "C"}, {9}}, {"planar_angle", {"A", "B", "theta"}, {1}}});
}

/// Crank 1 and rod 3 from the origin, the slider on the x axis, nominally at its turning point.
Mechanism slider_at_turning_point(bool driven_by_slider) {
  Sketch d("slider", 2);
  const int O = d.ground_point("O", {0, 0, 0}), x = d.ground_vector("x", {1, 0, 0});
  const int B = d.point("B", {1, 0, 0}), P = d.point("P", {4, 0, 0});
  d.body("crank", {O, B});
  const int rod = d.body("rod", {B, P});
  d.joint(JointType::revolute_on_slider, Sketch::ground, rod, {O, P}, {x});
  d.angle("theta", line(O, B)).driven = !driven_by_slider;
  d.along("s", O, P, x).driven = driven_by_slider;
  return d.release_pinned();
}

TEST(SpecialPosition, SliderAtItsTurningPointKeepsAllItsEquations) {
  const Model m = model_mechanism(slider_at_turning_point(false), {Polynomial{{0, 1}}}).model;
  expect_equations(m, 0, {{"planar_angle", {"O", "B", "theta"}, {1}}});
  expect_equations(m, 1, {{"length2", {"B", "P"}, {9}}, {"along2", {"O", "P", "x", "s"}, {}}});
  const Solved s(m, instants(1.5));
  for (int k = 0; k < s.instants() && !HasFailure(); ++k) {
    const double t = s.time(k);
    EXPECT_NEAR(s.scalar(k, "s"), std::cos(t) + std::sqrt(9 - std::sin(t) * std::sin(t)), 1e-12);
  }
  EXPECT_NO_THROW(model_mechanism(slider_at_turning_point(true), {Polynomial{{3.5, -1}}}));
}

TEST(SpecialPosition, RedundantLinkageDrawnFoldedKeepsEquationsThatDetermineIt) {
  // Two bell cranks joined by two couplers: one coupler too many. Folded, the first coupler
  // restricts the direction that the second crank does and the other one does not; in every other
  // position it is the other one that follows. Chosen for the folded position, the equations would
  // leave `far` undetermined everywhere else.
  const auto bell_cranks = [](double angle) {
    Sketch d("bell cranks", 2);
    int ends[2], ears[2];
    for (const int i : {0, 1}) {
      const std::string n = std::to_string(i + 1);
      const Vec foot{2.0 * i, 0, 0};
      const int D = d.ground_point("D" + n, foot);
      ends[i] = d.point("P" + n, foot + polar(1, angle));
      ears[i] = d.point("Q" + n, foot + polar(0.5, angle + 1));
      d.body("crank" + n, {D, ends[i], ears[i]});
      if (i == 0) d.angle("theta", line(D, ends[0])).driven = true;
    }
    d.bodies({{"coupler", {ends[0], ends[1]}}, {"second coupler", {ears[0], ears[1]}}});
    d.distance("far", ends[1], ears[0]);
    return d.release_pinned();
  };
  for (const double angle : {1.0, 0.0}) {
    const Model m = model_mechanism(bell_cranks(angle), {Polynomial{{1, 1}}}).model;
    std::set<std::string> kinds;
    for (const Stated& s : equations_of(m, 0)) kinds.insert(s.kind);
    EXPECT_TRUE(kinds.contains("distance2")) << "drawn at " << angle;
    if (!kinds.contains("distance2")) continue;
    Model open = m;  // solved away from the fold, where any choice would fail
    open.estimate = model_mechanism(bell_cranks(1), {Polynomial{{1, 1}}}).model.estimate;
    const Solved s(open, instants(1));
    for (int k = 0; k < s.instants() && !HasFailure(); ++k) {
      const Vec p = Vec{2, 0, 0} + polar(1, 1 + s.time(k));
      expect_near(s.position(k, "P2"), p, 1e-11, "P2");
      EXPECT_NEAR(s.scalar(k, "far"), norm(p - polar(0.5, 2 + s.time(k))), 1e-11);
    }
  }
}

}  // namespace
}  // namespace desmo::redundancy_test
