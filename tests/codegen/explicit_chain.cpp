// Parts of one kernel behind each other, solved in one call: as each by itself, whatever becomes of
// one of them.

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "formulations/equations/kernel_table.h"
#include "formulations/model/magnitudes.h"
#include "formulations/motion/internals.h"
#include "formulations/motion/time_stepping.h"
#include "formulations/parts/explicit_part.h"
#include "formulations/variants.h"
#include "tests/borrowed_part.h"
#include "tests/formulated.h"
#include "tests/mechanisms.h"

namespace desmo::explicit_chain_test {
namespace {

constexpr int dyads = 5;

/// The kernel of a dyad, refusing one part.
struct Refusing {
  static inline const ExplicitKernel* sound = nullptr;
  static inline const double* dimensions = nullptr;  // of the part; null: none

  static ExplicitChainResult solve(double* q, double* qd, double* qdd,
                                   const ExplicitBinding<double>* parts, int count) {
    int before = 0;
    while (before < count && parts[before].c != dimensions) ++before;
    return sound->solve[2](q, qd, qdd, parts, before);
  }
};

class Chains : public testing::Test {
 protected:
  Chains() {
    const std::vector<PartDefinition> parts = make_partition(m_, Partition::group);
    const Magnitudes magnitudes(m_);
    Refusing::sound = nullptr;
    std::vector<DefinedPart> defined;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      auto fallback = std::make_unique<Borrowed>(*parts_of(*reference_)[i].solver);
      if (i == 0) {
        defined.push_back({.definition = parts[i], .solver = std::move(fallback)});
        continue;
      }
      const BoundKernel bound = bind_kernel(m_, parts[i]).value();
      if (!Refusing::sound) {
        Refusing::sound = KernelTable::built_in().find_explicit_kernel(bound.kernel->fingerprint);
        kernel_ = *Refusing::sound;
        kernel_.solve[2] = &Refusing::solve;
      }
      auto part = std::make_unique<ExplicitPart>(kernel_, bound, magnitudes.weights(parts[i]),
                                                 PartSettings(settings_), std::move(fallback));
      dyads_.push_back(part.get());
      defined.push_back({.definition = parts[i], .solver = std::move(part)});
    }
    f_ = std::make_unique<TimeStepping>(m_, std::move(defined), settings_);
  }

  const Settings settings_{.tolerance = 1e-13};
  const Model m_ = four_bar_model(dyads);
  const std::unique_ptr<Formulation> reference_ =
      make_formulation(find_variant("group_automatic_eigen"), m_, settings_);
  ExplicitKernel kernel_{};
  std::vector<ExplicitPart*> dyads_;
  std::unique_ptr<Formulation> f_;
};

TEST_F(Chains, HoldPartsOfOneKernelAndNoOthers) {
  std::vector<Part*> solvers;
  for (const DefinedPart& part : parts_of(*f_)) solvers.push_back(part.solver.get());
  const std::span<Part* const> all(solvers);
  EXPECT_EQ(solvers.front()->make_chain(all), nullptr) << "the crank is none";
  const auto chain = solvers[1]->make_chain(all.subspan(1));
  ASSERT_NE(chain, nullptr);
  EXPECT_EQ(chain->size(), dyads);
  EXPECT_EQ(solvers[dyads]->make_chain(all.last(1)), nullptr) << "one is no chain";
  solvers.insert(solvers.begin() + 3, solvers.front());
  EXPECT_EQ(solvers[1]->make_chain(std::span(solvers).subspan(1))->size(), 2);
}

TEST_F(Chains, SolveNothingBeforeEveryMemberHasAPosition) {
  std::vector<Part*> solvers;
  for (ExplicitPart* const dyad : dyads_) solvers.push_back(dyad);
  const auto chain = solvers[0]->make_chain(solvers);
  State s = state_at_estimate(m_);
  EXPECT_EQ(chain->solve(s, 0, Level::acceleration).solved, 0);
  for (Part* const dyad : solvers)
    ASSERT_EQ(dyad->solve(s, s.q, Level::acceleration).status, Status::solved);
  EXPECT_EQ(chain->solve(s, 0, Level::acceleration).solved, dyads);
  EXPECT_EQ(chain->solve(s, 2, Level::acceleration).solved, dyads - 2);
  for (Part* const dyad : solvers) dyad->forget();
  chain->forget();
  EXPECT_EQ(chain->solve(s, 0, Level::acceleration).solved, 0);
}

/// The refused member is any, first and last among them.
TEST_F(Chains, GoOnBehindAMemberThatIsRefused) {
  constexpr int steps = 20;
  const auto expected = make_formulation(find_variant("group_symbolic_explicit"), m_, settings_);
  for (int refused = -1; refused < dyads; ++refused) {
    Refusing::dimensions = nullptr;
    ASSERT_TRUE(f_->assemble(0).ok() && expected->assemble(0).ok());
    Refusing::dimensions = refused < 0 ? nullptr : dyads_[refused]->binding().c;
    std::vector<long> before;
    for (const ExplicitPart* const dyad : dyads_) before.push_back(dyad->counts().fallbacks);
    for (int i = 1; i <= steps; ++i) {
      const Summary s = f_->step(0.01 * i);
      ASSERT_TRUE(s.ok() && expected->step(0.01 * i).ok());
      EXPECT_LT(s.residual, settings_.tolerance);
      EXPECT_LT(max_difference(f_->q(), expected->q()), 1e-11);
      EXPECT_LT(max_difference(f_->qdd(), expected->qdd()), 1e-10);
    }
    for (int k = 0; k < dyads; ++k)
      EXPECT_EQ(dyads_[k]->counts().fallbacks - before[k], k == refused ? steps : 0) << k;
  }
}

}  // namespace
}  // namespace desmo::explicit_chain_test
