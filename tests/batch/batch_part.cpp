// Copies of a piece of a mechanism in lanes: which are taken for copies, and what becomes of those
// that the code refuses.

#include "formulations/batch/batch_part.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <vector>

#include "formulations/model/magnitudes.h"
#include "formulations/model/partition.h"
#include "formulations/motion/internals.h"
#include "formulations/parts/explicit_part.h"
#include "formulations/variants.h"
#include "tests/borrowed_part.h"
#include "tests/mechanisms.h"

namespace desmo::batch_part_test {
namespace {

constexpr int refused_lane = 2;
constexpr std::size_t axle_size = 39, lever_size = 19;

/// Axles, levers and dampers of a truck, to be put into lanes.
class Pieces : public ::testing::Test {
 protected:
  void make(int axles) {
    model_ = truck_model(axles);
    definitions_ = make_partition(model_, Partition::group);
    reference_ = make_formulation(find_variant("group_automatic_eigen"), model_);
  }

  std::vector<std::size_t> of_size(std::size_t unknowns) const {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < definitions_.size(); ++i)
      if (definitions_[i].unknowns.size() == unknowns) result.push_back(i);
    return result;
  }

  std::unique_ptr<ExplicitPart> part(std::size_t i, const ExplicitKernel& kernel) {
    return std::make_unique<ExplicitPart>(
        kernel, bind_kernel(model_, definitions_[i]).value(),
        Magnitudes(model_).weights(definitions_[i]), PartSettings({.tolerance = 1e-11}),
        std::make_unique<Borrowed>(*parts_of(*reference_)[i].solver));
  }

  const ExplicitKernel& kernel(std::size_t i) const {
    return *KernelTable::built_in().find_explicit_kernel(
        bind_kernel(model_, definitions_[i])->kernel->fingerprint);
  }

  Subsystem copy(const std::vector<std::size_t>& parts) {
    Subsystem result;
    for (const std::size_t i : parts) result.push_back(part(i, kernel(i)));
    return result;
  }

  bool alike(const Subsystem& a, const Subsystem& b) const {
    std::vector<const ExplicitPart*> of_a, of_b;
    for (const auto& p : a) of_a.push_back(p.get());
    for (const auto& p : b) of_b.push_back(p.get());
    return are_alike(of_a, of_b);
  }

  /// Returns the origin of each position in the state.
  std::vector<StateKind> kinds() const {
    std::vector<StateKind> result(model_.state_size(), StateKind::constant);
    std::fill_n(result.begin(), model_.coordinates(), StateKind::solved);
    for (const Driver& d : model_.drivers)
      result[model_.entities[d.coordinate].first] = StateKind::driven;
    return result;
  }

  std::vector<int> unknowns(const std::vector<std::vector<std::size_t>>& copies) const {
    std::vector<int> result;
    for (const auto& parts : copies)
      for (const std::size_t p : parts)
        std::ranges::copy(definitions_[p].unknowns, std::back_inserter(result));
    return result;
  }

  /// Unknowns of these parts, and the drivers that `together` does not read in the state.
  void spoil(const std::vector<std::vector<std::size_t>>& copies, const BatchPart& together,
             State& s) const {
    for (const int k : unknowns(copies)) s.q[k] = s.qd[k] = s.qdd[k] = 17;
    for (const int k : together.inputs({}).drivers) s.q[k] = s.qd[k] = s.qdd[k] = 17;
  }

  /// Drivers as they are in a state.
  struct Driven {
    Driven(const BatchPart& part, const State& s) {
      for (const int k : part.inputs({}).drivers) {
        z.push_back(s.q[k]);
        zd.push_back(s.qd[k]);
        zdd.push_back(s.qdd[k]);
      }
    }
    MotionRow row() const { return {z.data(), zd.data(), zdd.data()}; }
    std::vector<double> z, zd, zdd;
  };

  /// Four copies, of one of which the code refuses the last part: that one alone is solved by other
  /// parts, and rightly.
  void refuse_last_part(const std::vector<std::vector<std::size_t>>& copies) {
    static const LaneKernel* sound = nullptr;
    SubsystemKernels kernels;
    for (const std::size_t i : copies.front())
      kernels.push_back(KernelTable::built_in().find_lane_kernel(kernel(i).fingerprint, 4));
    sound = kernels.back();
    ASSERT_NE(sound, nullptr);
    LaneKernel refusing = *sound;
    refusing.solve = [](double* q, double* qd, double* qdd, const ExplicitBinding<double>& binding,
                        double* residual2) {
      LaneResult r = sound->solve(q, qd, qdd, binding, residual2);
      r.accepted &= ~(1u << refused_lane);
      return r;
    };
    kernels.back() = &refusing;
    ExplicitKernel refused = kernel(copies[refused_lane].back());
    refused.solve[2] = [](double*, double*, double*, const ExplicitBinding<double>*, int) {
      return ExplicitChainResult{};
    };

    std::vector<Subsystem> subsystems;
    std::vector<const ExplicitPart*> seen;
    for (const auto& parts : copies) {
      subsystems.push_back(copy(parts));
      if (subsystems.size() == refused_lane + 1)
        subsystems.back().back() = part(parts.back(), refused);
      for (const auto& part : subsystems.back()) seen.push_back(part.get());
    }
    const ExplicitPart* const other = subsystems[refused_lane].back().get();
    BatchPart together({kernels}, std::move(subsystems), kinds(), Guess::previous);

    ASSERT_TRUE(reference_->assemble(0).ok());
    State s = stepping_of(*reference_).state();
    const State expected = s;
    for (int i = 0; i < 3; ++i) {
      if (i > 0)  // found again, and not left as they were
        for (const int k : unknowns(copies)) s.qd[k] = s.qdd[k] = 17;
      ASSERT_EQ(together.solve(s, expected.q, Level::acceleration).status, Status::solved);
    }
    for (const ExplicitPart* const p : seen) EXPECT_EQ(p->counts().fallbacks, p == other ? 2 : 0);
    EXPECT_EQ(together.counts().fallbacks, 2);

    // Predicted, with nobody who reads anything: the state knows nothing of unknowns and drivers.
    together.bind({std::vector<bool>(model_.state_size(), false), {}, Level::acceleration});
    const Driven drivers(together, expected);
    EXPECT_EQ(drivers.z.empty(), copies.front().size() == 1);  // levers have none
    for (int i = 0; i < 2; ++i) {
      spoil(copies, together, s);
      const std::vector<double> last = s.q;
      together.begin_step({0.01, 0.01, Level::acceleration, Level::acceleration}, drivers.row());
      ASSERT_EQ(together.solve(s, last, Level::acceleration).status, Status::solved);
    }
    EXPECT_EQ(together.counts().fallbacks, 4);
    std::vector<double> last = s.q;
    together.restore(last);
    together.store(s);
    for (int i = 0; i < model_.coordinates(); ++i) EXPECT_NEAR(last[i], s.q[i], 1e-10) << i;
    for (int i = 0; i < model_.coordinates(); ++i) {
      EXPECT_NEAR(s.q[i], expected.q[i], 1e-10) << i;
      EXPECT_NEAR(s.qd[i], expected.qd[i], 1e-9) << i;
      EXPECT_NEAR(s.qdd[i], expected.qdd[i], 1e-8) << i;
    }
  }

  Model model_;
  std::vector<PartDefinition> definitions_;
  std::unique_ptr<Formulation> reference_;
};

TEST_F(Pieces, OfOnePartThatAreRefusedFallBackAlone) {
  make(2);
  std::vector<std::vector<std::size_t>> copies;
  for (const std::size_t lever : of_size(lever_size)) copies.push_back({lever});
  ASSERT_EQ(copies.size(), 4u);
  refuse_last_part(copies);
}

TEST_F(Pieces, OfSeveralPartsThatAreRefusedFallBackAlone) {
  make(4);
  const auto axles = of_size(axle_size), levers = of_size(lever_size);
  std::vector<std::vector<std::size_t>> copies;
  for (std::size_t a = 0; a < 4; ++a)
    copies.push_back({axles[a], levers[2 * a], levers[2 * a + 1]});
  refuse_last_part(copies);
}

/// Predicted, what nobody reads stays in lanes. From the state, it is left complete.
TEST_F(Pieces, LeaveInTheStateWhatIsReadThere) {
  make(2);
  std::vector<std::vector<std::size_t>> copies;
  std::vector<Subsystem> subsystems;
  SubsystemKernels kernels;
  for (const std::size_t lever : of_size(lever_size)) {
    copies.push_back({lever});
    subsystems.push_back(copy({lever}));
    kernels = {KernelTable::built_in().find_lane_kernel(kernel(lever).fingerprint, 4)};
  }
  BatchPart together({kernels}, std::move(subsystems), kinds(), Guess::previous);
  std::vector<bool> read(model_.state_size(), false);
  const int there = definitions_[copies[1][0]].unknowns[3];
  read[there] = true;
  together.bind({read, {}, Level::acceleration});
  ASSERT_TRUE(reference_->assemble(0).ok());
  State s = stepping_of(*reference_).state();
  const State expected = s;
  for (int i = 0; i < 2; ++i)
    ASSERT_EQ(together.solve(s, s.q, Level::acceleration).status, Status::solved);
  EXPECT_EQ(together.counts().fallbacks, 0);

  spoil(copies, together, s);
  const Driven drivers(together, expected);
  together.begin_step({0.01, 0.01, Level::acceleration}, drivers.row());
  ASSERT_EQ(together.solve(s, s.q, Level::acceleration).status, Status::solved);
  for (const int k : unknowns(copies)) {
    EXPECT_NEAR(s.q[k], k == there ? expected.q[k] : 17, 1e-10) << k;
    EXPECT_NEAR(s.qdd[k], k == there ? expected.qdd[k] : 17, 1e-7) << k;
  }
  together.store(s);
  for (const int k : unknowns(copies)) EXPECT_NEAR(s.q[k], expected.q[k], 1e-10) << k;

  for (const int k : unknowns(copies))
    if (k != there) s.q[k] += 1e-7;
  together.begin_step({0.01, 0.01, std::nullopt}, drivers.row());
  ASSERT_EQ(together.solve(s, s.q, Level::acceleration).status, Status::solved);
  for (const int k : unknowns(copies)) EXPECT_NEAR(s.q[k], expected.q[k], 1e-10) << k;
}

TEST_F(Pieces, AreCopiesWhereTheyTakeTheSameFromEachOther) {
  make(2);
  const auto axles = of_size(axle_size), levers = of_size(lever_size);
  const Subsystem first = copy({axles[0], levers[0], levers[1]}),
                  second = copy({axles[1], levers[2], levers[3]});
  EXPECT_TRUE(alike(first, first));
  EXPECT_TRUE(alike(first, second));
  EXPECT_FALSE(alike(first, copy({axles[1], levers[2], levers[1]})));  // a lever of the other axle
  EXPECT_FALSE(alike(first, copy({axles[1], levers[2]})));
  EXPECT_FALSE(alike(first, copy({levers[2], axles[1], levers[3]})));
  EXPECT_FALSE(alike(copy({levers[0], levers[0]}), copy({levers[0], levers[1]})));
}

}  // namespace
}  // namespace desmo::batch_part_test
