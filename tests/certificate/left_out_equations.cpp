// Equations that modelling left out: those that hold but for the digits of the file are not
// flagged, others are, with their misfit.

#include "formulations/verification/branch/left_out_equations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "cases/io/files.h"
#include "formulations/constraints/kinds.h"
#include "formulations/model/characteristic_lengths.h"
#include "formulations/model/plan.h"
#include "formulations/model/scales.h"
#include "formulations/modelling/modelling.h"
#include "formulations/motion/groupwise/double_solution.h"
#include "formulations/verification/branch/branch_path.h"
#include "formulations/verification/branch/chosen_equations.h"
#include "formulations/verification/branch/file_variation.h"
#include "formulations/verification/certificate/refinement.h"
#include "tests/accuracy/scenes.h"
#include "tests/certificate/starts.h"
#include "tests/flaps.h"
#include "tests/mechanisms.h"
#include "tests/overconstrained.h"

namespace desmo::left_out_equations_test {
namespace {

/// Misfits at instants of a motion.
struct Found {
  int instants = 0, proven = 0, flagged = 0;
  Misfit largest{};
};

Found find(const Model& m, const std::vector<double>& times) {
  LeftOutEquations left_out(m);
  Refinement refinement(m);
  Found found;
  for (const ReferenceInstant& s : double_solution(m, times)) {
    const RefinedInstant& r = refinement.refine(instant_of(s));
    ++found.instants;
    found.proven += r.proven;
    const auto misfit = left_out.check(r);
    if (!misfit) continue;
    ++found.flagged;
    if (misfit->amount > found.largest.amount) found.largest = *misfit;
  }
  return found;
}
Found find(const Scene& scene) {
  const Model m = make_model(scene);
  EXPECT_TRUE(LeftOutEquations(m).any()) << scene.mechanism.name;
  return find(m, sampled(scene.grid, scene.grid.instants));
}

TEST(LeftOutEquations, HoldInTheCasesAndTheLibrary) {
  for (const auto& [m, grid] : every_motion()) {
    const Found found = find(m, sampled(grid, std::min(grid.instants, DESMO_SANITIZED ? 5 : 60)));
    EXPECT_EQ(found.flagged, 0) << m.name << ": " << found.largest.amount << " of "
                                << m.constraints[std::max(0, found.largest.constraint)].name;
    EXPECT_EQ(found.proven, found.instants) << m.name;
  }
}

TEST(LeftOutEquations, HoldWhereALinkageClosesBeforeRounding) {
  for (int i = 0; i < 12; i += DESMO_SANITIZED ? 6 : 1)
    for (const auto& [size, from_origin] :
         {std::pair(1.L, 0.L), std::pair(1e-3L, 7.1L), std::pair(350.L, 0.3L)}) {
      const long double start = 0.8L + 0.1L * i;
      for (const Scene& scene : {bennett(start, 17, size, from_origin),
                                 parallel_cranks(start, 17, true, 0, size, from_origin),
                                 parallel_cranks(start, 17, false, 0, size, from_origin)}) {
        const Found found = find(scene);
        EXPECT_EQ(found.flagged, 0)
            << scene.mechanism.name << ' ' << i << ' ' << size << ": " << found.largest.amount;
      }
    }
}

/// The misfit is that of one unit of the last digit, but for how many numbers there are.
TEST(LeftOutEquations, DoNotHoldForFewerDigits) {
  for (const int digits : {6, 9, 12})
    for (int i = 0; i < (DESMO_SANITIZED ? 1 : 3); ++i) {
      const long double start = 0.83L + 0.41L * i;
      for (const Scene& scene : {bennett(start, digits), parallel_cranks(start, digits, true),
                                 parallel_cranks(start, digits, false)}) {
        const Found found = find(scene);
        EXPECT_EQ(found.proven, found.instants);
        EXPECT_GT(found.flagged, found.instants / 2);
        EXPECT_GT(found.largest.amount, 0.03 * std::pow(10., -digits));
        EXPECT_LT(found.largest.amount, 30 * std::pow(10., -digits));
      }
    }
}

/// A crank that is longer by ε leaves a misfit of ε (1 − cos θ), θ from the drawing on.
TEST(LeftOutEquations, HaveTheMisfitOfACrankThatIsTooLong) {
  for (const bool stated : {true, false})
    for (const auto& [longer, from_origin] :
         {std::pair(1e-12, 0.L), std::pair(1e-10, 0.L), std::pair(1e-8, 0.L),
          // Digits of coordinates leave 1e-13 there, and must not be multiplied by the distance.
          std::pair(1e-10, 1000.L)}) {
      const Found found = find(parallel_cranks(1.1L, 17, stated, longer, 1, from_origin));
      EXPECT_GT(found.flagged, found.instants / 2) << longer << ", " << from_origin;
      EXPECT_TRUE(is_length(found.largest.kind));
      EXPECT_NEAR(found.largest.amount / longer, 1 - std::cos(1.), 0.3) << longer;
    }
}

/// Numbers of a scene's file: coordinates of points and lengths of links.
std::vector<double*> numbers_of(Mechanism& m) {
  std::vector<double*> numbers;
  for (Mechanism::Point& p : m.points)
    for (int i = 0; i < m.dimension; ++i) numbers.push_back(&p.position[i]);
  for (Mechanism::Body& b : m.bodies)
    if (b.length) numbers.push_back(&b.length->value);
  return numbers;
}

/// The misfit that the numbers of the file explain, each varied by u times itself, is found by
/// varying each by much more. One as large is not flagged, one twelve times as
/// large is: numbers that vary together count each by itself.
TEST(LeftOutEquations, ExplainHardlyMoreThanTheDigits) {
  constexpr double varied = 1e-7, u = 0x1p-53;
  for (const bool stated : {true, false})
    for (const long double start : {0.83L, 1.24L, 1.65L}) {
      if (DESMO_SANITIZED && start > 1) break;
      const auto misfit = [&](Scene scene) { return find(make_model(scene), {1.}).largest.amount; };
      const auto cranks = [&](long double longer) {
        return parallel_cranks(start, 17, stated, longer);
      };
      Scene scene = cranks(0);
      double explained = 0;
      for (double* x : numbers_of(scene.mechanism)) {
        const double before = std::exchange(*x, *x * (1 + varied));
        explained += misfit(scene) / varied * u;
        *x = before;
      }
      const double of_longer = misfit(cranks(varied)) / varied;
      EXPECT_EQ(misfit(cranks(explained / of_longer)), 0);
      EXPECT_NEAR(misfit(cranks(12 * explained / of_longer)), 12 * explained, 5 * explained);
    }
}

Model flaps_model(int count, double farther) {
  return make_model(parse_scene(flaps(count, farther), "flaps.json", ""));
}

TEST(LeftOutEquations, HaveTheMisfitOfAShapeOnTheGround) {
  for (const double farther : {0., 1e-9, 4e-7}) {
    const Model m = flaps_model(1, farther);
    EXPECT_EQ(LeftOutEquations(m).any(), farther > 0);
    const Found found = find(m, {0, 0.5, 1});
    EXPECT_EQ(found.proven, found.instants);
    EXPECT_EQ(found.flagged, farther > 0 ? found.instants : 0);
    EXPECT_NEAR(found.largest.amount, farther, 1e-3 * farther);
  }
}

/// Two flaps with the same wrong length: a request of one alone still shows it.
TEST(LeftOutEquations, OfAShapeOnTheGroundAreThoseOfEachGroup) {
  const Model m = flaps_model(2, 4e-7);
  for (const char* end : {"F1", "F2"}) {
    const Plan plan = make_plan(m, std::vector{Output{m.find(end), Level::position}});
    EXPECT_TRUE(LeftOutEquations(plan.model).any()) << end;
    const auto unseen = std::ranges::count(plan.groups, true, &Plan::GroupUse::may_lock);
    EXPECT_EQ(unseen, 1) << end;  // the other flap
  }
}

TEST(LeftOutEquations, OfAShapeOnTheGroundAreNoneToChoose) {
  const Model m = flaps_model(1, 4e-7);
  EXPECT_TRUE(LeftOutEquations(m).any());
  EXPECT_FALSE(has_other_equations(m));
}

/// A small amount of a short length may be worse than a larger one of an angle.
TEST(LeftOutEquations, CompareMisfitsOverTheirLengths) {
  const Model m = make_model(parallel_cranks(1.1L, 17, true, 1e-8));
  const Misfit found = find(m, {0.5}).largest;
  EXPECT_EQ(found.relative,
            found.over(CharacteristicLengths(m).of(m.constraints[found.constraint])));
  LeftOutEquations left_out(m);
  const Misfit length{0, 1e-9, EntityKind::distance, 1e-6}, angle{1, 1e-7, EntityKind::angle, 1e-7};
  for (const Misfit& misfit : {angle, length, angle})
    left_out.note(LeftOutEquations::Between{misfit, 0});
  EXPECT_TRUE(is_length(left_out.between()->misfit.kind));
}

/// The enclosure of what holds grows with about the sixth power of the step: a step of 0.72 rad
/// leaves 1e-4 of lengths, these leave a third and three times as much.
TEST(LeftOutEquations, AreToldAlongStepsThatAreShortEnough) {
  const Model m = make_model(parallel_cranks(1.1L, 17, true));
  LeftOutEquations left_out(m);
  Refinement refinement(m);
  BranchPath path(m);
  bool is_told = false;
  path.ask_about_steps([&](const PathProof& step) { return is_told = left_out.look_along(step); });
  for (const double step : {0.6, 0.85}) {
    const auto ends = double_solution(m, std::vector{0., step});
    ASSERT_TRUE(path.start_at(refined(refinement, ends[0])));
    const FollowedStep followed = path.follow(refined(refinement, ends[1]));
    EXPECT_EQ(followed.end, PathEnd::same);
    EXPECT_EQ(followed.sub_steps == 1, step < 0.7);
    EXPECT_TRUE(is_told);
  }
}

/// Far from the origin, digits leave about a tenth of what a drawing may leave, which a shorter
/// step shows, or about all of it, which none does.
TEST(LeftOutEquations, AreToldAsFarAsDigitsGo) {
  for (const long double from_origin : {6e10L, 3e11L}) {
    const Model m = make_model(parallel_cranks(1.1L, 17, true, 0, 1, from_origin));
    LeftOutEquations left_out(m);
    BranchPath path(m, 100);
    path.ask_about_steps([&](const PathProof& step) { return left_out.look_along(step); });
    ASSERT_TRUE(path.start_at({0, {m.estimate, {}, {}}, {}}));
    const FollowedStep followed = path.go_to(0.85);
    EXPECT_EQ(followed.end, PathEnd::same);
    EXPECT_EQ(followed.sub_steps == 1, from_origin > 1e11L);
  }
}

/// Dimensions that are not the drawing's vary by the reach of what they are measured between.
TEST(FileVariation, OfStatedDimensionsIsOfTheirLastDigits) {
  for (const auto& [drawn, grid] : every_motion()) {
    Model m = drawn;
    for (Constraint& c : m.constraints)
      if (description_of(c.kind).table < 0)
        for (Derived& d : c.constants) d = d * Derived(1.001);
    const double size = nominal_size(m);
    for (const Constraint& c : with_file_variation(m).constraints)
      for (const double slack : c.slack) EXPECT_LE(slack, 1e-14 * size) << m.name << ' ' << c.name;
  }
}

}  // namespace
}  // namespace desmo::left_out_equations_test
