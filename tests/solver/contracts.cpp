// Promises of public headers about calls that go wrong, and code that must not compile.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "cases/generators/cases.h"
#include "formulations/model/plan.h"
#include "formulations/modelling/modelling.h"
#include "formulations/variants.h"
#include "formulations/verification/certificate/certificate.h"
#include "formulations/verification/condition.h"
#include "formulations/verification/error.h"
#include "formulations/verification/run/checked_run.h"
#include "formulations/verification/run/live_run.h"

namespace desmo::contracts_test {
namespace {

template <class Model>
concept Formulated = requires(const Variant& v, Model&& m) {
  make_formulation(v, std::forward<Model>(m));
};
using Instants = std::vector<ReferenceInstant>;

// No verdict of a Summary on what it cannot judge.
static_assert(!std::is_convertible_v<CheckedSummary&, const Summary&>);
static_assert(!std::is_convertible_v<LiveSummary&, const Summary&>);
// An argument that must outlive an object is no temporary.
static_assert(Formulated<const Model&> && !Formulated<Model>);
static_assert(std::is_constructible_v<Certifier, const Model&> &&
              !std::is_constructible_v<Certifier, Model>);
static_assert(std::is_constructible_v<ConditionNumber, const Model&> &&
              !std::is_constructible_v<ConditionNumber, Model>);
static_assert(std::is_constructible_v<ErrorMeasure, const Model&, const Instants&, Scales> &&
              !std::is_constructible_v<ErrorMeasure, const Model&, Instants, Scales>);

TEST(Contracts, StepsGoToAnyFiniteTime) {
  const Model m = make_model(four_bar(2));
  const auto f = make_formulation(find_variant("block_automatic_klu"), m);
  ASSERT_TRUE(f->assemble(0).ok());
  const std::vector<double> start(f->q().begin(), f->q().end());
  for (const double t : {0.01, 0.02, 0.02, 0.03, 0.01, -0.05, 0.0})
    ASSERT_TRUE(f->step(t).ok()) << t;
  for (std::size_t i = 0; i < start.size(); ++i) EXPECT_NEAR(f->q()[i], start[i], 1e-8) << i;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double t : {std::nan(""), infinity, -infinity}) {
    EXPECT_EQ(f->step(t).status, Status::not_finite) << t;
    EXPECT_TRUE(f->step(0.01).ok()) << t;
  }
}

TEST(Contracts, RefuseLevelsOfWrongSizeAndUnknownEntities) {
  const Model m = make_model(four_bar(2));
  const auto f = make_formulation(find_variant("block_automatic_klu"), m);
  const std::vector<Level> few(m.coordinates() - 1, Level::position);
  EXPECT_THROW(f->solve_only(few), std::invalid_argument);
  EXPECT_THROW(f->solve_only({}), std::invalid_argument);
  EXPECT_THROW(LiveRun(*f, {.levels = few}), std::invalid_argument);
  for (const EntityId id : {-1, static_cast<EntityId>(m.entities.size())})
    EXPECT_THROW(make_plan(m, std::vector{Output{id, Level::position}}), std::invalid_argument);
  const std::vector<Output> twice{{0, Level::position}, {0, Level::velocity}};
  EXPECT_EQ(make_plan(m, twice).outputs.size(), 2u);
}

}  // namespace
}  // namespace desmo::contracts_test
