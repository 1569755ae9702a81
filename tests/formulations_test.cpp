// Every formulation of the table, on every case and size, against the quadruple reference and
// against the exact property of the equal-length chain.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bench/suite/cell.h"
#include "cases/cases.h"
#include "formulations/reference.h"
#include "formulations/variants.h"
#include "tests/every_variant.h"
#include "tests/mechanisms.h"

namespace desmo {
namespace {

/// The whole motion at the smallest size, 6 s of it at the others.
/// desmo_bench verifies all of it before it times anything.
suite::Options test_options(const Case& definition, int coordinates) {
  suite::Options o;
  o.duration = coordinates == definition.sizes.front() ? DESMO_TEST_SECONDS
                                                       : std::min<double>(DESMO_TEST_SECONDS, 6);
  o.slow_limit = 558;
  return o;
}

/// References are expensive: all formulations of one case and size share one test and one.
class Sizes : public testing::TestWithParam<std::pair<const Case*, int>> {};

TEST_P(Sizes, EveryFormulationAgreesWithTheQuadrupleReference) {
  const auto [definition, coordinates] = GetParam();
  suite::ReferenceCache references;
  int verified = 0;
  for (const Variant& v : variants()) {
    suite::Cell cell(*definition, coordinates, v, test_options(*definition, coordinates));
    if (cell.state == suite::Cell::State::not_run) continue;
    cell.verify(references);
    EXPECT_EQ(cell.state, suite::Cell::State::verified) << cell.name() << ": " << cell.message;
    EXPECT_GE(cell.errors.instants, 50) << cell.name();
    EXPECT_LE(cell.errors.position, 1e-9) << cell.name();
    EXPECT_LE(cell.errors.velocity, 1e-8) << cell.name();
    EXPECT_LE(cell.errors.acceleration, 1e-7) << cell.name();
    EXPECT_LT(cell.residual, 1e-10) << cell.name();
    ++verified;
  }
  EXPECT_GE(verified, static_cast<int>(variants().size()) - 4);  // dense global ones are limited
}

std::vector<std::pair<const Case*, int>> all_sizes() {
  std::vector<std::pair<const Case*, int>> result;
  for (const Case& c : cases())
    for (const int n : c.sizes) result.emplace_back(&c, n);
  return result;
}

INSTANTIATE_TEST_SUITE_P(Cases, Sizes, testing::ValuesIn(all_sizes()), [](const auto& info) {
  return std::string(info.param.first->name) + "_" + std::to_string(info.param.second);
});

/// Dense global solves at the larger sizes take too long for the whole motion.
TEST_P(Sizes, DenseGlobalSolvesAgreeOverAShorterMotion) {
  const auto [definition, coordinates] = GetParam();
  suite::Options options;
  options.duration = DESMO_TEST_SECONDS < 2 ? 0.02 : 0.5;
  options.dense_limit = 558;
  suite::ReferenceCache references;
  int verified = 0;
  for (const Variant& v : variants()) {
    if (!is_dense_global(v)) continue;
    suite::Cell cell(*definition, coordinates, v, options);
    cell.verify(references);
    EXPECT_EQ(cell.state, suite::Cell::State::verified) << cell.name() << ": " << cell.message;
    ++verified;
  }
  EXPECT_EQ(verified, 4);
}

/// Equal lengths: every rocker moves in parallel with the first.
class ChainSink final : public Sink {
 public:
  explicit ChainSink(const Mechanism& m) {
    for (int k = 1; k < m.structural_groups(); ++k) {
      const std::string dyad = "dyad" + std::to_string(k) + "/";
      c_.push_back(m.entities[m.find(dyad + "C")].first);
      psi_.push_back(m.entities[m.find(dyad + "psi")].first);
    }
  }
  void accept(const Instant& instant) override {
    for (std::size_t k = 1; k < c_.size(); ++k)
      worst = std::max({worst, std::abs(instant.q[c_[k]] - (instant.q[c_[0]] + 6.0 * k)),
                        std::abs(instant.q[c_[k] + 1] - instant.q[c_[0] + 1]),
                        std::abs(instant.q[psi_[k]] - instant.q[psi_[0]])});
    ++instants;
  }
  double worst = 0;
  int instants = 0;

 private:
  std::vector<int> c_, psi_;  // first coordinate of each dyad's
};

TEST_P(EveryVariant, KeepsTheChainParallel) {
  const Variant& v = GetParam();
  const Mechanism m = four_bar_mechanism(is_dense_global(v) ? 37 : 185);
  ChainSink sink(m);
  const TimeGrid grid = time_grid(DESMO_TEST_SECONDS, 0.01);
  const Summary s = make_formulation(v, m)->run(grid, {}, sink);
  EXPECT_TRUE(s.ok()) << describe(s, m);
  EXPECT_EQ(sink.instants, grid.instants);
  EXPECT_LT(sink.worst, 1e-9);
}

TEST_P(EveryVariant, RepeatsARunToTheLastBit) {
  const Mechanism m = truck_mechanism(1);
  const auto f = make_formulation(GetParam(), m);
  struct Last final : Sink {
    std::vector<double> values;
    void accept(const Instant& i) override {
      values.assign(i.q.begin(), i.q.end());
      values.insert(values.end(), i.qdd.begin(), i.qdd.end());
    }
  } first, second;
  // Pivots chosen in the first run may serve the second; the third starts like the second.
  const TimeGrid grid = time_grid(0.5, 0.01);
  f->run(grid, {}, first);
  f->run(grid, {}, first);
  f->run(grid, {}, second);
  EXPECT_EQ(first.values, second.values);
}

TEST_P(EveryVariant, TakesAFixedNumberOfIterationsWhereAsked) {
  const Mechanism m = truck_mechanism(1);
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

TEST_P(EveryVariant, SolvesOnlyTheLevelAsked) {
  const Mechanism m = truck_mechanism(1);
  struct Spans final : Sink {
    std::size_t q = 0, qd = 0, qdd = 0;
    void accept(const Instant& i) override { q = i.q.size(), qd = i.qd.size(), qdd = i.qdd.size(); }
  } sink;
  const auto f = make_formulation(GetParam(), m);
  f->run(time_grid(0.1, 0.01), {Level::position}, sink);
  EXPECT_EQ(sink.q, 114u);
  EXPECT_EQ(sink.qd, 0u);
  f->run(time_grid(0.1, 0.01), {Level::velocity}, sink);
  EXPECT_EQ(sink.qd, 114u);
  EXPECT_EQ(sink.qdd, 0u);
}

TEST_P(EveryVariant, VelocitiesAndAccelerationsAreDerivativesOfPositions) {
  const Mechanism m = truck_mechanism(1);
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

INSTANTIATE_TEST_SUITE_P(Table, EveryVariant,
                         testing::ValuesIn(variants().begin(), variants().end()),
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
  const Mechanism m = truck_mechanism(1);
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
  const Mechanism m = four_bar_mechanism(1);
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
}  // namespace desmo
