#pragma once

#include <memory>
#include <vector>

#include "formulations/equations/lane_kernel.h"
#include "formulations/explicit_part.h"
#include "formulations/guarded_part.h"
#include "formulations/lane_transport.h"
#include "formulations/lane_values.h"

namespace desmo {

/// Parts of one type, none of which needs another, solved several at once by explicit code on wide
/// registers. A part that has no position yet, or that the code refuses, is solved alone, by its
/// own ExplicitPart.
class LanePart final : public GuardedPart {
 public:
  /// kernels: of one type, with more lanes each than the one before. members: two or more, bound to
  /// the explicit kernel of that type.
  LanePart(std::vector<const LaneKernel*> kernels,
           std::vector<std::unique_ptr<ExplicitPart>> members);

  PartResult solve(State& state, Level level) override;
  std::vector<int> starts_from(const std::vector<int>& unknowns) const override;
  void forget() override;

  /// Of its members.
  long fallbacks() const override;
  long branch_changes() const override;

 private:
  /// Members of one call of the kernel; where they are fewer than lanes, the first fills the rest.
  struct Batch {
    const LaneKernel& kernel;
    std::vector<ExplicitPart*> members;
    LanePlaces positions, rates, unknowns;  // of the kernel's lists
    LaneValues c{}, f{}, w{}, branch{};
    ExplicitBinding<double> binding{};
  };
  const LaneKernel& kernel_for(std::size_t members) const;
  Batch make_batch(std::size_t first);
  void pack_branches(Batch& batch) const;
  void solve(Batch& batch, State& state, Level level, PartResult& result, double& residual2);

  std::vector<const LaneKernel*> kernels_;
  std::vector<std::unique_ptr<ExplicitPart>> members_;
  std::vector<Batch> batches_;
  std::vector<int> identity_;
  LaneState local_;
};

}  // namespace desmo
