// Assembled equations of whole mechanisms: automatic and symbolic, global and by group.

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <random>

#include "cases/cases.h"
#include "formulations/equations/automatic.h"
#include "formulations/equations/symbolic.h"
#include "formulations/group_type.h"
#include "formulations/partition.h"
#include "formulations/reference.h"

namespace desmo {
namespace {

struct Parameter {
  const char* name;
  Mechanism (*build)(int);
  Partition partition;
};

std::vector<double> random_near(const std::vector<double>& center, double radius, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-radius, radius);
  std::vector<double> result = center;
  for (double& x : result) x += uniform(generator);
  return result;
}

std::vector<double> nominal_state(const Mechanism& m) {
  std::vector<double> state = m.estimate;
  state.insert(state.end(), m.fixed_values.begin(), m.fixed_values.end());
  return state;
}

template <class Equations>
Eigen::VectorXd residual(const Equations& e, const std::vector<double>& state) {
  Eigen::VectorXd phi(e.pattern().n);
  e.residual(state.data(), phi.data());
  return phi;
}

/// Φ_φ and Φ_h as a dense matrix over the components of the state.
template <class Equations>
Eigen::MatrixXd jacobian(const Equations& e, const std::vector<double>& state) {
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
    dense(p.known[k].row, p.known[k].state) = values[p.dependent_entries() + k];
  EXPECT_TRUE(dense.allFinite()) << "an entry was not written";
  return dense;
}

class Equations : public testing::TestWithParam<Parameter> {
 protected:
  Mechanism m = GetParam().build(2);
  std::vector<PartDefinition> parts = make_partition(m, GetParam().partition);
};

template <class E>
void expect_derivative(const E& equations, const Mechanism& m, const PartDefinition& part) {
  const std::vector<double> state = random_near(nominal_state(m), 0.05, 7);
  const Eigen::MatrixXd dense = jacobian(equations, state);
  const std::vector<bool> constant = constant_coordinates(m);
  for (int j = 0; j < m.coordinates(); ++j) {
    if (constant[j] && !part.constant) continue;  // it never moves
    const double h = 1e-5;
    std::vector<double> plus = state, minus = state;
    plus[j] += h;
    minus[j] -= h;
    const Eigen::VectorXd difference =
        (residual(equations, plus) - residual(equations, minus)) / (2 * h);
    EXPECT_LT((difference - dense.col(j)).lpNorm<Eigen::Infinity>(), 1e-8) << "coordinate " << j;
  }
}

TEST_P(Equations, JacobianIsTheDerivativeOfTheResidual) {
  for (const PartDefinition& part : parts) {
    expect_derivative(AutomaticEquations(m, part), m, part);
    expect_derivative(SymbolicEquations(m, part), m, part);
  }
}

TEST_P(Equations, SymbolicAndAutomaticAgreeToRounding) {
  const std::vector<double> state = random_near(nominal_state(m), 0.3, 3);
  std::vector<double> rate = random_near(std::vector<double>(state.size(), 0.0), 2, 4);
  std::fill(rate.begin() + m.coordinates(), rate.end(), 0.0);
  const std::vector<bool> constant = constant_coordinates(m);
  for (int i = 0; i < m.coordinates(); ++i)
    if (constant[i]) rate[i] = 0;
  for (const PartDefinition& part : parts) {
    const AutomaticEquations a(m, part);
    const SymbolicEquations s(m, part);
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

TEST_P(Equations, PartsAreSquareAndCoverEveryDependentCoordinate) {
  std::vector<int> times_solved(m.coordinates(), 0);
  for (const PartDefinition& part : parts) {
    EXPECT_EQ(constraint_of_row(m, part).size(), part.unknowns.size());
    for (const int i : part.unknowns) ++times_solved[i];
  }
  for (const Driver& d : m.drivers) ++times_solved[m.entities[d.coordinate].first];
  for (const int times : times_solved) EXPECT_EQ(times, 1);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, Equations,
    testing::Values(Parameter{"four_bar_global", four_bar, Partition::global},
                    Parameter{"four_bar_group", four_bar, Partition::group},
                    Parameter{"truck_suspension_global", truck_suspension, Partition::global},
                    Parameter{"truck_suspension_group", truck_suspension, Partition::group}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(Kernels, OneServesEveryGroupOfItsType) {
  // Left and right twins, and all axles and dyads: six types and the constant ground.
  EXPECT_EQ(kernels().size(), 6u);
  const Mechanism m = truck_suspension(3);
  EXPECT_EQ(bind_kernel(m, 2).kernel, bind_kernel(m, 3).kernel);
  EXPECT_EQ(bind_kernel(m, 1).kernel, bind_kernel(m, 11).kernel);
  EXPECT_NE(bind_kernel(m, 1).kernel, bind_kernel(m, 2).kernel);
}

TEST(Kernels, AreMissingVisibly) {
  Mechanism m;
  m.name = "other";
  m.add_group("lonely", {"1"});
  const std::array<double, 2> at{1, 1};
  const EntityId p = m.add(EntityKind::point, "p", at, 0);
  const EntityId a = m.add_fixed(EntityKind::point, "a", std::array{0.0, 0.0});
  const EntityId b = m.add_fixed(EntityKind::point, "b", std::array{2.0, 0.0});
  m.constrain<Length<2>>(0, "to a", {a, p}, {4});
  m.constrain<Length<2>>(0, "to b", {b, p}, {4});
  EXPECT_EQ(find_kernel(describe_group(m, 0).fingerprint), nullptr);
  try {
    bind_kernel(m, 0);
    FAIL();
  } catch (const std::invalid_argument& e) {
    EXPECT_NE(std::string(e.what()).find("lonely"), std::string::npos);
  }
}

TEST(Partition, RefusesAGroupThatNeedsALaterOne) {
  Mechanism m = four_bar(2);
  m.entities[m.find("dyad1/C")].group = 2;
  EXPECT_THROW(make_partition(m, Partition::group), std::invalid_argument);
}

TEST(Pattern, RefusesTheSameDerivativeTwice) {
  const Mechanism m = four_bar(1);
  const PartDefinition part = make_partition(m, Partition::global).front();
  const JacobianEntry twice[] = {{0, part.unknowns[0]}, {0, part.unknowns[0]}};
  EXPECT_THROW(make_pattern(m, part, twice), std::invalid_argument);
}

}  // namespace
}  // namespace desmo
