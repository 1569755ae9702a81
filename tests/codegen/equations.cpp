// Assembled equations of whole mechanisms: automatic and symbolic, global and by group.

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <random>

#include "formulations/equations/automatic.h"
#include "formulations/equations/symbolic.h"
#include "formulations/model/partition.h"
#include "tests/formulated.h"
#include "tests/mechanisms.h"

namespace desmo::equations_test {
namespace {

struct Parameter {
  const char* name;
  Model (*build)(int);
  Partition partition;
};

std::vector<double> random_near(const std::vector<double>& center, double radius, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-radius, radius);
  std::vector<double> result = center;
  for (double& x : result) x += uniform(generator);
  return result;
}

Eigen::VectorXd residual(const desmo::Equations& e, const std::vector<double>& state) {
  Eigen::VectorXd phi(e.pattern().n);
  e.residual(state.data(), phi.data());
  return phi;
}

/// Φ_φ and Φ_h as a dense matrix over the components of the state.
Eigen::MatrixXd jacobian(const desmo::Equations& e, const std::vector<double>& state) {
  const Pattern& p = e.pattern();
  std::vector<double> values(p.size(), NAN);  // every entry must be written
  e.constant_jacobian(values.data());
  e.jacobian(state.data(), values.data());
  e.known_jacobian(state.data(), values.data());
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(p.n, static_cast<int>(state.size()));
  for (int j = 0; j < p.n; ++j)
    for (int k = p.column_start[j]; k < p.column_start[j + 1]; ++k)
      dense(p.row[k], p.unknowns[j]) = values[k];
  for (std::size_t k = 0; k < p.known.size(); ++k)
    dense(p.known[k].row, p.known[k].place) = values[p.dependent_entries() + k];
  EXPECT_TRUE(dense.allFinite()) << "an entry was not written";
  return dense;
}

SymbolicEquations symbolic(const Model& m, const PartDefinition& part) {
  return SymbolicEquations(m, part, bind_kernels(m, part).value());
}

class Equations : public testing::TestWithParam<Parameter> {
 protected:
  Model m = GetParam().build(2);
  std::vector<PartDefinition> parts = make_partition(m, GetParam().partition);
};

/// The symbolic one is compared with it below.
TEST_P(Equations, JacobianIsTheDerivativeOfTheResidual) {
  const std::vector<double> state = random_near(state_at_estimate(m).q, 0.05, 7);
  const std::vector<EntityId> owner = entity_of_coordinate(m);
  for (const PartDefinition& part : parts) {
    const AutomaticEquations equations(m, part);
    const Eigen::MatrixXd dense = jacobian(equations, state);
    for (int j = 0; j < m.coordinates(); ++j) {
      if (m.is_at_rest(owner[j]) && !part.constant) continue;
      const double h = 1e-5;
      std::vector<double> plus = state, minus = state;
      plus[j] += h;
      minus[j] -= h;
      const Eigen::VectorXd difference =
          (residual(equations, plus) - residual(equations, minus)) / (2 * h);
      EXPECT_LT((difference - dense.col(j)).lpNorm<Eigen::Infinity>(), 1e-8) << "coordinate " << j;
    }
  }
}

TEST_P(Equations, SymbolicAndAutomaticAgreeToRounding) {
  const std::vector<double> state = random_near(state_at_estimate(m).q, 0.3, 3);
  std::vector<double> rate = random_near(std::vector<double>(state.size(), 0.0), 2, 4);
  std::fill(rate.begin() + m.coordinates(), rate.end(), 0.0);
  const std::vector<EntityId> owner = entity_of_coordinate(m);
  for (int i = 0; i < m.coordinates(); ++i)
    if (m.is_at_rest(owner[i])) rate[i] = 0;
  for (const PartDefinition& part : parts) {
    const AutomaticEquations a(m, part);
    const SymbolicEquations s = symbolic(m, part);
    EXPECT_EQ(a.pattern().column_start, s.pattern().column_start);
    EXPECT_EQ(a.pattern().row, s.pattern().row);
    EXPECT_LT((residual(a, state) - residual(s, state)).lpNorm<Eigen::Infinity>(), 1e-12);
    EXPECT_LT((jacobian(a, state) - jacobian(s, state)).lpNorm<Eigen::Infinity>(), 1e-12);
    Eigen::VectorXd ga(a.pattern().n), gs(a.pattern().n);
    a.quadratic(state.data(), rate.data(), ga.data());
    s.quadratic(state.data(), rate.data(), gs.data());
    EXPECT_LT((ga - gs).lpNorm<Eigen::Infinity>(), 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Cases, Equations,
    testing::Values(Parameter{"four_bar_global", four_bar_model, Partition::global},
                    Parameter{"four_bar_group", four_bar_model, Partition::group},
                    Parameter{"four_bar_block", four_bar_model, Partition::block},
                    Parameter{"truck_suspension_global", truck_model, Partition::global},
                    Parameter{"truck_suspension_group", truck_model, Partition::group},
                    Parameter{"truck_suspension_block", truck_model, Partition::block}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(Partition, RefusesAGroupThatNeedsALaterOne) {
  Model m = four_bar_model(2);
  m.entities[m.find("dyad1/C")].group = 2;
  EXPECT_THROW(make_partition(m, Partition::group), std::invalid_argument);
}

TEST(Pattern, RefusesTheSameDerivativeTwice) {
  const Model m = four_bar_model(1);
  const PartDefinition part = make_partition(m, Partition::global).front();
  const JacobianEntry twice[] = {{0, part.unknowns[0]}, {0, part.unknowns[0]}};
  EXPECT_THROW(make_pattern(m, part, twice), std::invalid_argument);
}

}  // namespace
}  // namespace desmo::equations_test
