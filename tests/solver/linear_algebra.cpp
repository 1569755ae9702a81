// Each backend on its own, through a part whose equations are linear in known ways: the tolerance
// comes from the rounding unit and the conditioning, not from taste.

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "formulations/algebra/backend.h"
#include "formulations/algebra/klu_factors.h"
#include "formulations/model/magnitudes.h"
#include "formulations/model/part_system.h"
#include "formulations/parts/newton_part.h"
#include "formulations/variants.h"
#include "formulations/verification/reference/reference.h"
#include "tests/formulated.h"
#include "tests/mechanisms.h"

namespace desmo::linear_algebra_test {
namespace {

bool solves_normal_equations(const Backend& backend) {
  return backend.name == "cholmod" || backend.name == "ma27";
}

PartContext context(const Model& m, const PartDefinition& part, const Settings& settings) {
  return {m, part, Magnitudes(m).weights(part), std::nullopt, settings, PartSettings(settings)};
}

class EveryBackend : public testing::TestWithParam<const Backend*> {};

/// One Newton step too many would hide a bad solver: velocities are one linear solve. Their
/// backward error in ‖Φ_φ q̇ + Φ_h ḣ‖ must be a small multiple of ε ‖Φ_φ‖ ‖q̇‖, times cond for
/// the normal equations.
TEST_P(EveryBackend, VelocityHasASmallBackwardError) {
  const Model m = truck_model(1);
  for (const PartDefinition& part : make_partition(m, Partition::global)) {
    if (part.constant) continue;
    const auto at = reference_solution(m, std::vector{0.3}, Precision::standard)[0];
    State s{at.q, at.qd, at.qdd};
    s.resize(m.state_size());
    std::copy(m.fixed_values.begin(), m.fixed_values.end(), s.q.begin() + m.coordinates());
    const auto solver = make_newton_part(context(m, part, {.tolerance = 1e-8}), *GetParam());
    ASSERT_EQ(solver->solve(s, s.q, Level::velocity).status, Status::solved);

    ScalarState<double> solved(m.state_size());
    solved.q = s.q;
    solved.qd = s.qd;
    const PartSystem<double> system(m, part, solved);
    const auto n = static_cast<Eigen::Index>(system.n);
    const Eigen::MatrixXd jacobian =
        Eigen::Map<const Eigen::MatrixXd>(system.jacobian.data(), n, n).transpose();
    const Eigen::Map<const Eigen::VectorXd> right(system.velocity.data(), n);
    Eigen::VectorXd qd(n);
    for (Eigen::Index j = 0; j < n; ++j) qd[j] = s.qd[part.unknowns[j]];
    const double condition = jacobian.norm() * jacobian.inverse().norm();
    const double allowed = 50 * std::numeric_limits<double>::epsilon() * jacobian.norm() *
                           qd.norm() * (solves_normal_equations(*GetParam()) ? condition : 1);
    EXPECT_LT((jacobian * qd - right).norm(), allowed);
  }
}

struct AtTheFold {
  PartResult result;
  double psi_rate;
};

/// Velocity of a dyad folded onto itself, rocker along the coupler: the position is exact and Φ_φ
/// exactly singular.
AtTheFold velocity_at_the_fold(const Backend& backend, const Settings& settings) {
  Model m = four_bar_model(1);
  m.fixed_values[m.entities[m.find("dyad1/D")].first] = 2;
  State s = state_at_estimate(m);
  const auto set = [&](std::vector<double>& target, const char* name, int i, double value) {
    target[m.entities[m.find(name)].first + i] = value;
  };
  set(s.q, "crank/B", 0, 2);
  set(s.q, "crank/B", 1, 0);
  set(s.q, "dyad1/C", 0, 8);
  set(s.q, "dyad1/C", 1, 0);
  set(s.q, "dyad1/psi", 0, 0);
  set(s.qd, "crank/B", 0, 2);
  const auto parts = make_partition(m, Partition::group);
  const auto solver = make_newton_part(context(m, parts[1], settings), backend);
  const PartResult result = solver->solve(s, s.q, Level::velocity);
  return {result, s.qd[m.entities[m.find("dyad1/psi")].first]};
}

/// The normal equations may lose the last zero to rounding, but not more than that.
TEST_P(EveryBackend, NeverCallsASingularPositionSolved) {
  const AtTheFold fold = velocity_at_the_fold(*GetParam(), {});
  if (solves_normal_equations(*GetParam()) && fold.result.status == Status::solved)
    EXPECT_GT(std::abs(fold.psi_rate), 1e6);
  else
    EXPECT_EQ(fold.result.status, Status::singular);
}

std::vector<const Backend*> all_backends() { return {backends().begin(), backends().end()}; }

INSTANTIATE_TEST_SUITE_P(Table, EveryBackend, testing::ValuesIn(all_backends()),
                         [](const auto& info) { return std::string(info.param->name); });

/// KLU factorises the blocks that it finds, or one; the solution is the same.
TEST(Klu, LeavesOutTheBlocksOfAMatrix) {
  const Pattern triangle{3, {0, 1, 2}, {0, 2, 4, 5}, {0, 1, 1, 2, 2}, {}};
  const double values[] = {2, 1, 4, 3, 5};
  for (const BlockTriangularForm btf : {BlockTriangularForm::on, BlockTriangularForm::off}) {
    KluFactors klu(triangle, btf);
    const std::size_t blocks = btf == BlockTriangularForm::on ? 3 : 1;
    EXPECT_EQ(klu.block_start().size(), blocks + 1);
    ASSERT_TRUE(klu.factor(values));
    double x[] = {2, 9, 21};
    klu.solve(x);
    EXPECT_NEAR(x[0], 1, 1e-15);
    EXPECT_NEAR(x[1], 2, 1e-15);
    EXPECT_NEAR(x[2], 3, 1e-15);
  }
}

TEST(Klu, SolvesAMechanismAsOneBlock) {
  const Model m = truck_model(2);
  const auto f = formulated("global_automatic_klu", m),
             one = formulated("global_automatic_klu/btf:off", m);
  ASSERT_TRUE(f->assemble(0.3).ok() && one->assemble(0.3).ok());
  EXPECT_LT(max_difference(one->q(), f->q()), 1e-11);
  EXPECT_LT(max_difference(one->qdd(), f->qdd()), 1e-9);
  EXPECT_FALSE(std::ranges::equal(one->qdd(), f->qdd()))
      << "another order of elimination rounds otherwise";
}

TEST(Klu, CallsAPositionSingularAsOneBlockToo) {
  const Backend& klu = *find_backend("klu");
  EXPECT_EQ(velocity_at_the_fold(klu, {.btf = BlockTriangularForm::off}).result.status,
            Status::singular);
}

TEST(Backends, HaveNamesAndVersions) {
  std::set<std::string_view> names;
  for (const Backend* b : backends()) {
    EXPECT_TRUE(names.insert(b->name).second);
    EXPECT_FALSE(b->version().empty()) << b->name;
  }
}

}  // namespace
}  // namespace desmo::linear_algebra_test
