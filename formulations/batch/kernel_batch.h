#pragma once

#include <vector>

#include "formulations/base/lane_values.h"
#include "formulations/equations/lane_kernel.h"
#include "formulations/parts/explicit_part.h"

namespace desmo {

/// A batch of parts of one type, one in each lane, bound to a kernel for as many lanes.
class KernelBatch {
 public:
  /// lanes: as many as the kernel's, bound to the explicit kernel of its type; a part may stand in
  /// several. They outlive the batch. in: where each local input stands in the arrays that solve()
  /// is given.
  KernelBatch(const LaneKernel& kernel, std::vector<ExplicitPart*> lanes, std::vector<int> in);
  KernelBatch(KernelBatch&&) = default;  // what the binding points to comes along

  /// Solves positions, velocities and accelerations, which lanes hold side by side. residual2:
  /// ‖Φ‖₂² of each lane. Positions and rates of a lane that is not accepted are unspecified.
  LaneResult solve(LaneState& state, double* residual2) const {
    return kernel_.solve(state.q.data(), state.qd.data(), state.qdd.data(), binding_, residual2);
  }

  /// Takes over the branches that the parts have now; angles lose their anchors.
  void take_branches();

  bool assembled() const;

 private:
  const LaneKernel& kernel_;
  std::vector<ExplicitPart*> lanes_;
  std::vector<int> in_;
  LaneValues c_, f_, w_, branch_, anchors_;
  ExplicitBinding<double> binding_;
};

}  // namespace desmo
