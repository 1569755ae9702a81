#pragma once

#include <memory>
#include <vector>

#include "formulations/equations/lanes.h"
#include "formulations/explicit_part.h"
#include "formulations/guarded_part.h"
#include "formulations/lane_transport.h"

namespace desmo {

/// Parts of one type, none of which needs another, solved several at once by explicit code on wide
/// registers. A part that has no position yet, or that the code refuses, is solved alone, by its
/// own ExplicitPart.
class LanePart final : public GuardedPart {
 public:
  /// members: two or more, bound to the explicit kernel of that type.
  LanePart(const LaneKernel& kernel, std::vector<std::unique_ptr<ExplicitPart>> members);

  PartResult solve(State& state, Level level) override;
  std::vector<int> starts_from(const std::vector<int>& unknowns) const override;
  void forget() override;

  /// Of its members.
  long fallbacks() const override;
  long branch_changes() const override;

 private:
  /// Members of one call of the kernel; where they are fewer than lanes, the first fills the rest.
  struct Batch {
    std::vector<ExplicitPart*> members;
    LanePlaces positions, rates, unknowns;  // of the kernel's lists
    std::vector<Lanes> c{}, f{}, w{}, branch{};
    ExplicitBinding<Lanes> binding{};
  };
  Batch make_batch(std::size_t first);
  void pack_branches(Batch& batch);
  void solve(Batch& batch, State& state, Level level, PartResult& result, double& residual2);

  const LaneKernel& kernel_;
  std::vector<std::unique_ptr<ExplicitPart>> members_;
  std::vector<Batch> batches_;
  std::vector<int> identity_;
  std::vector<Lanes> q_, qd_, qdd_;
};

}  // namespace desmo
