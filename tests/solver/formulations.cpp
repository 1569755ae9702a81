// Every formulation of the table, on every case and size, against the quadruple reference and
// against the exact property of the equal-length chain.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bench/kit/variant_costs.h"
#include "cases/generators/cases.h"
#include "formulations/modelling/modelling.h"
#include "formulations/variants.h"
#include "formulations/verification/reference/reference.h"
#include "tests/every_variant.h"
#include "tests/everything.h"
#include "tests/mechanisms.h"

namespace desmo::formulations_test {
namespace {

constexpr double short_motion = DESMO_SANITIZED ? 0.05 : 0.5;  // s

/// A motion of a case, and its reference at up to 51 instants.
class Motion {
 public:
  Motion(const Case& definition, int coordinates, double seconds)
      : model(make_model(make_scene(definition, coordinates))),
        grid(time_grid(seconds, seconds > 6 ? 0.02 : 0.01)) {
    const int pieces = std::min(50, grid.instants - 1);
    for (int i = 0; i <= pieces; ++i)
      compared.push_back(static_cast<int>(long{i} * (grid.instants - 1) / pieces));
    std::vector<double> times;
    for (const int i : compared) times.push_back(grid.time(i));
    Reference made = make_reference(model, times);
    for (const Level level : all_levels) EXPECT_LT(made.floor[level], 1e-20) << model.name;
    reference = std::move(made.instants);
  }

  const Model model;
  const TimeGrid grid;
  std::vector<int> compared;  // instants of the grid
  std::vector<ReferenceInstant> reference;
};

/// Returns a motion, solved once for all tests of a process.
const Motion& motion_of(const Case& definition, int coordinates, double seconds) {
  static std::map<std::tuple<std::string, int, double>, std::unique_ptr<const Motion>> all;
  auto& motion = all[{std::string(definition.name), coordinates, seconds}];
  if (!motion) motion = std::make_unique<const Motion>(definition, coordinates, seconds);
  return *motion;
}

/// The largest differences from the reference of a motion.
class LargestDifference final : public Observer {
 public:
  explicit LargestDifference(const Motion& motion) : motion_(motion) {}
  Flow observe(const Instant& instant) noexcept override {
    if (instants == motion_.compared.size() || instant.index != motion_.compared[instants])
      return Flow::go_on;
    const ReferenceInstant& r = motion_.reference[instants++];
    widen(of.position, instant.q, r.q);
    widen(of.velocity, instant.qd, r.qd);
    widen(of.acceleration, instant.qdd, r.qdd);
    return Flow::go_on;
  }
  PerLevel<double> of{};
  std::size_t instants = 0;  // compared so far

 private:
  static void widen(double& largest, std::span<const double> a, const std::vector<double>& b) {
    for (std::size_t i = 0; i < b.size(); ++i)
      if (!(std::abs(a[i] - b[i]) <= largest)) largest = std::abs(a[i] - b[i]);
  }
  const Motion& motion_;
};

void expect_agreement(const Variant& v, const Motion& motion) {
  const auto where = [&] { return v.id + " on " + motion.model.name; };
  LargestDifference difference(motion);
  const Summary s = make_formulation(v, motion.model)->run(motion.grid, {}, difference);
  EXPECT_TRUE(s.ok()) << where() << ": " << describe(s, motion.model);
  EXPECT_EQ(difference.instants, motion.compared.size()) << where();
  EXPECT_LE(difference.of.position, 1e-9) << where();
  EXPECT_LE(difference.of.velocity, 1e-8) << where();
  EXPECT_LE(difference.of.acceleration, 1e-7) << where();
  EXPECT_LT(s.residual, 1e-10) << where();
}

/// References are expensive: all formulations of one case and size share one test and one.
class Sizes : public testing::TestWithParam<std::pair<const Case*, int>> {};

/// Every formulation solves the whole motion at the smallest size and a part of it at the others.
TEST_P(Sizes, EveryFormulationAgreesWithTheQuadrupleReference) {
  const auto [definition, coordinates] = GetParam();
  const bool smallest = coordinates == definition->sizes.front();
  const Motion& motion =
      motion_of(*definition, coordinates, smallest ? DESMO_TEST_SECONDS : short_motion);
  for (const Variant& v : tested_variants())
    if (!bench::is_dense_global(v) || coordinates <= 114) expect_agreement(v, motion);
}

/// All sizes; with sanitizers the two smallest, as more of the same finds no other error of memory.
std::vector<std::pair<const Case*, int>> tested_sizes() {
  std::vector<std::pair<const Case*, int>> result;
  for (const Case& c : cases())
    for (std::size_t i = 0; i < (DESMO_SANITIZED ? 2 : c.sizes.size()); ++i)
      result.emplace_back(&c, c.sizes[i]);
  return result;
}

INSTANTIATE_TEST_SUITE_P(Cases, Sizes, testing::ValuesIn(tested_sizes()), [](const auto& info) {
  return std::string(info.param.first->name) + "_" + std::to_string(info.param.second);
});

/// Dense global solves at the larger sizes take too long for the whole motion.
TEST_P(Sizes, DenseGlobalSolvesAgreeOverAShorterMotion) {
  const auto [definition, coordinates] = GetParam();
  const Motion& motion = motion_of(*definition, coordinates, short_motion);
  for (const Variant& v : variants())
    if (bench::is_dense_global(v)) expect_agreement(v, motion);
}

class LargestSizes : public testing::TestWithParam<const Case*> {};

/// The paper's reference and the fastest formulation stand for all over a longer motion.
TEST_P(LargestSizes, TwoFormulationsAgreeOverALongerMotion) {
  const Case& definition = *GetParam();
  const double duration = DESMO_SANITIZED ? short_motion : 6;
  const Motion& motion = motion_of(definition, definition.sizes.back(), duration);
  for (const char* id : {"global_automatic_klu", "group_symbolic_explicit"})
    expect_agreement(find_variant(id), motion);
}

std::vector<const Case*> all_cases() {
  std::vector<const Case*> result;
  for (const Case& c : cases()) result.push_back(&c);
  return result;
}

INSTANTIATE_TEST_SUITE_P(Cases, LargestSizes, testing::ValuesIn(all_cases()),
                         [](const auto& info) { return std::string(info.param->name); });

/// Equal lengths: every rocker moves in parallel with the first.
class ChainObserver final : public Observer {
 public:
  explicit ChainObserver(const Model& m) {
    for (int k = 1; k < m.structural_groups(); ++k) {
      const std::string dyad = "dyad" + std::to_string(k) + "/";
      c_.push_back(m.entities[m.find(dyad + "C")].first);
      psi_.push_back(m.entities[m.find(dyad + "psi")].first);
    }
  }
  Flow observe(const Instant& instant) noexcept override {
    for (std::size_t k = 1; k < c_.size(); ++k)
      worst = std::max({worst, std::abs(instant.q[c_[k]] - (instant.q[c_[0]] + 6.0 * k)),
                        std::abs(instant.q[c_[k] + 1] - instant.q[c_[0] + 1]),
                        std::abs(instant.q[psi_[k]] - instant.q[psi_[0]])});
    ++instants;
    return Flow::go_on;
  }
  double worst = 0;
  int instants = 0;

 private:
  std::vector<int> c_, psi_;  // first coordinate of each dyad's
};

class EveryFormulation : public EveryVariant {};

TEST_P(EveryFormulation, KeepsTheChainParallel) {
  const Variant& v = GetParam();
  struct Motion {
    int dyads;
    double seconds;
  };
  // A turn of the crank takes 6.3 s; the longer chain shows what errors grow by along it.
  const Motion turn{37, std::min<double>(DESMO_TEST_SECONDS, 7)};
  const Motion begin{bench::is_dense_global(v) ? 37 : 185, DESMO_SANITIZED ? 0.2 : 1};
  for (const auto& [dyads, seconds] : {turn, begin}) {
    const Model m = four_bar_model(dyads);
    ChainObserver observer(m);
    const TimeGrid grid = time_grid(seconds, 0.01);
    const Summary s = make_formulation(v, m)->run(grid, {}, observer);
    EXPECT_TRUE(s.ok()) << dyads << ": " << describe(s, m);
    EXPECT_EQ(observer.instants, grid.instants) << dyads;
    EXPECT_LT(observer.worst, 1e-9) << dyads;
  }
}

TEST_P(EveryFormulation, RepeatsARunToTheLastBit) {
  const Model m = truck_model(1);
  const auto f = make_formulation(GetParam(), m);
  Everything first(51), second(51);
  // Pivots chosen in the first run may serve the second; the third starts like the second.
  const TimeGrid grid = time_grid(0.5, 0.01);
  ASSERT_TRUE(f->run(grid, {}, first).ok());
  ASSERT_TRUE(f->run(grid, {}, first).ok());
  ASSERT_TRUE(f->run(grid, {}, second).ok());
  EXPECT_EQ(first.all, second.all);
}

TEST_P(EveryFormulation, TakesAFixedNumberOfIterationsWhereAsked) {
  const Model m = truck_model(1);
  const auto usual = make_formulation(GetParam(), m);
  const auto fixed = make_formulation(GetParam(), m, {.fixed_iterations = 4});
  for (int i = 0; i < 10; ++i) {
    const double t = 0.01 * i;
    ASSERT_TRUE(usual->step(t).ok());
    const Summary s = fixed->step(t);
    ASSERT_TRUE(s.ok()) << describe(s, m);
    EXPECT_EQ(s.iterations, 4) << t;
  }
  EXPECT_LT(fixed->step(0.09).residual, Settings{}.tolerance);
  for (int i = 0; i < m.coordinates(); ++i) EXPECT_NEAR(fixed->q()[i], usual->q()[i], 1e-9) << i;
}

TEST_P(EveryFormulation, SolvesOnlyTheLevelAsked) {
  const Model m = truck_model(1);
  struct Spans final : Observer {
    std::size_t q = 0, qd = 0, qdd = 0;
    Flow observe(const Instant& i) noexcept override {
      q = i.q.size(), qd = i.qd.size(), qdd = i.qdd.size();
      return Flow::go_on;
    }
  } observer;
  const auto f = make_formulation(GetParam(), m);
  ASSERT_TRUE(f->run(time_grid(0.1, 0.01), {Level::position}, observer).ok());
  EXPECT_EQ(observer.q, 114u);
  EXPECT_EQ(observer.qd, 0u);
  ASSERT_TRUE(f->run(time_grid(0.1, 0.01), {Level::velocity}, observer).ok());
  EXPECT_EQ(observer.qd, 114u);
  EXPECT_EQ(observer.qdd, 0u);
}

TEST_P(EveryFormulation, VelocitiesAndAccelerationsAreDerivativesOfPositions) {
  const Model m = truck_model(1);
  const auto f = make_formulation(GetParam(), m, Settings{1e-13, 25});
  const double t = 0.7, h = 1e-4;
  std::vector<double> q[3];
  ASSERT_TRUE(f->assemble(t - h).ok());
  q[0].assign(f->q().begin(), f->q().end());
  ASSERT_TRUE(f->step(t + h).ok());
  q[2].assign(f->q().begin(), f->q().end());
  ASSERT_TRUE(f->step(t).ok());
  q[1].assign(f->q().begin(), f->q().end());
  for (int i = 0; i < m.coordinates(); ++i) {
    EXPECT_NEAR(f->qd()[i], (q[2][i] - q[0][i]) / (2 * h), 1e-5) << i;
    EXPECT_NEAR(f->qdd()[i], (q[2][i] - 2 * q[1][i] + q[0][i]) / (h * h), 1e-3) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Table, EveryFormulation, testing::ValuesIn(tested_variants()),
                         EveryVariant::name);

TEST(Variants, TableHoldsEveryPointOfTheDesign) {
  for (const char* id : {"global_automatic_klu", "global_symbolic_klu", "group_automatic_lapack",
                         "group_symbolic_lapack", "group_symbolic_eigen", "group_symbolic_inlined",
                         "group_symbolic_explicit", "block_automatic_klu", "block_symbolic_inlined",
                         "block_symbolic_explicit"})
    EXPECT_EQ(find_variant(id).id, id);
  EXPECT_THROW(find_variant("group_symbolic_ma57"), std::invalid_argument);
}

TEST(Reference, QuadrupleAndDoubleDifferByRoundingOnly) {
  const Model m = truck_model(1);
  const std::vector<double> times{0, 0.5, 1};
  const auto standard = reference_solution(m, times, Precision::standard);
  const auto quadruple = reference_solution(m, times, Precision::quadruple);
  for (std::size_t k = 0; k < times.size(); ++k)
    for (int i = 0; i < m.coordinates(); ++i) {
      EXPECT_NEAR(standard[k].q[i], quadruple[k].q[i], 1e-9);
      EXPECT_NEAR(standard[k].qdd[i], quadruple[k].qdd[i], 1e-7);
    }
}

TEST(Reference, SatisfiesTheClosedFormOfTheFourBar) {
  const Model m = four_bar_model(1);
  const double t = 0.8;
  const auto r = reference_solution(m, std::vector{0.0, t}, Precision::quadruple)[1];
  // C is where circles about B and D meet, above the line BD.
  const double theta = std::acos(0.5) + t, bx = 2 * std::cos(theta), by = 2 * std::sin(theta);
  const double dx = 6 - bx, dy = -by, d2 = dx * dx + dy * dy, height = std::sqrt(36 / d2 - 0.25);
  const int c = m.entities[m.find("dyad1/C")].first;
  EXPECT_NEAR(r.q[c], bx + dx / 2 - height * dy, 1e-14);
  EXPECT_NEAR(r.q[c + 1], by + dy / 2 + height * dx, 1e-14);
}

}  // namespace
}  // namespace desmo::formulations_test
