// The experiment modelling: its problems in other coordinates, and their linear systems.

#include "formulations/modelling/modelling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "bench/experiments/modelling/problems.h"
#include "bench/kit/formulation_candidate.h"
#include "bench/kit/verification.h"
#include "cases/generators/cases.h"

namespace desmo::modelling_experiment_test {
namespace {

using modelling::LinearSystems;

TEST(LinearSystems, AreThoseThatLibrariesGet) {
  const auto of = [](Modelling kind, Partition partition) {
    return modelling::linear_systems(make_model(truck_suspension(2), kind), partition);
  };
  for (const Partition p : {Partition::global, Partition::group}) {
    EXPECT_EQ(of(Modelling::natural, p).unknowns, 2 * 109);
    EXPECT_EQ(of(Modelling::natural, p).condensation, 0);
    EXPECT_EQ(of(Modelling::basis, p).unknowns, 2 * 85);
    EXPECT_EQ(of(Modelling::reference, p).unknowns, 2 * 86);
    EXPECT_EQ(of(Modelling::relative, p).unknowns, 2 * 21);
  }
  const LinearSystems whole = of(Modelling::relative, Partition::global),
                      parts = of(Modelling::relative, Partition::group);
  EXPECT_GT(whole.entries, parts.entries);
  EXPECT_GT(whole.condensation, parts.condensation);
}

// Candidates have code of their own, and are compared with the reference of the natural model: a
// wrong coordinate is refused.
TEST(ModellingProblems, AreVerifiedByNames) {
  const Scene scene = truck_suspension(1);
  const TimeGrid grid{.start = 0, .step = 0.01, .instants = 5};
  const bench::Problem natural = modelling::natural_problem(scene, grid);
  for (const Modelling kind : {Modelling::basis, Modelling::reference, Modelling::relative}) {
    const bench::Problem right = modelling::problem_in(scene, natural, kind);
    ASSERT_EQ(static_cast<int>(right.delivered.size()), natural.plan.model.coordinates());
    bench::Problem swapped = right;
    std::swap(swapped.delivered.front(), swapped.delivered.back());
    for (const char* natural_id :
         {"group_automatic_klu", "group_symbolic_inlined", "group_symbolic_explicit"}) {
      const std::string id = modelling::id_in(natural_id, kind);
      // Generated code of `basis` would be that of natural coordinates.
      EXPECT_EQ(id.empty(), kind == Modelling::basis && !id.starts_with("group_automatic"));
      if (id.empty()) continue;
      bench::FormulationCandidate candidate(right, id, Settings{}),
          mistaken(swapped, id, Settings{});
      candidate.verify();
      EXPECT_TRUE(candidate.is_verified()) << candidate.message();
      mistaken.verify();
      EXPECT_TRUE(mistaken.is_failed());
    }
    // Derived coordinates add equations, except in `basis`.
    const double ratio = modelling::condition_at_start(right.plan.model, 0) /
                         modelling::condition_at_start(natural.plan.model, 0);
    EXPECT_EQ(kind == Modelling::basis, std::abs(ratio - 1) < 1e-9) << ratio;
  }
}

// A build without GPL libraries compares the others.
TEST(ModellingProblems, LeaveOutAFormulationThatTheBuildLacks) {
  EXPECT_EQ(modelling::id_in("global_automatic_klu", Modelling::natural), "global_automatic_klu");
  EXPECT_EQ(modelling::id_in("global_automatic_absent", Modelling::natural), "");
}

}  // namespace
}  // namespace desmo::modelling_experiment_test
