#pragma once

#include <memory>
#include <span>
#include <vector>

#include "formulations/guarded_part.h"
#include "formulations/lane_stage.h"
#include "formulations/lane_transport.h"
#include "formulations/lane_values.h"

namespace desmo {

/// Copies of one and the same piece of a mechanism, none of which needs another, solved several at
/// once by explicit code on wide registers: parts of one type, or each copy several parts, whose
/// results then stay in lanes until all are found. A copy that has no position yet, or of which the
/// code refuses a part, is solved alone, by its own parts.
class LanePart final : public GuardedPart {
 public:
  /// The parts of a copy, in the order of solution.
  using Copy = std::vector<std::unique_ptr<ExplicitPart>>;
  /// For each part of a copy the kernel of its type, all of as many lanes.
  using Kernels = std::vector<const LaneKernel*>;

  /// kernels: one or more, each for more lanes than the one before. copies: two or more, as alike
  /// as are_copies() says.
  /// constant: of each position in the state, whether it never moves.
  LanePart(std::vector<Kernels> kernels, std::vector<Copy> copies, std::vector<bool> constant);

  PartResult solve(State& state, std::span<const double> last, Level level) override;
  std::vector<int> starts_from(const std::vector<int>& unknowns) const override;
  void write_only(const std::vector<bool>& read) override;
  void forget() override;

  /// Of its members.
  long fallbacks() const override;
  long branch_changes() const override;

 private:
  /// Copies of one call of each kernel; where they are fewer than lanes, the first fills the rest.
  struct Batch {
    std::span<Copy> copies;
    std::vector<LaneStage> stages;
    LanePlaces constants, positions, rates;  // what comes from the state: once, and in every step
    LanePlaces unknowns, unknowns_read;      // what goes there: positions; velocities and so on
    LaneState local;
    bool assembled = false;  // every part, since forget()
  };
  const Kernels& kernels_for(std::size_t copies) const;
  Batch make_batch(std::span<Copy> copies, const Kernels& kernels,
                   const std::vector<bool>& constant);
  unsigned solve_in_lanes(Batch& batch, PartResult& result, double* residual2);
  void solve(Batch& batch, State& state, std::span<const double> last, Level level,
             PartResult& result, double& residual2);
  void solve_alone(Copy& copy, State& state, std::span<const double> last, Level level,
                   PartResult& result, double& residual2);

  std::vector<Kernels> kernels_;
  std::vector<Copy> copies_;
  std::vector<int> states_;  // that the first copy reads and writes, ascending: its local inputs
  std::vector<Batch> batches_;
};

/// Whether both have parts of the same types, in the same order, that take the same from each
/// other.
bool are_copies(std::span<const ExplicitPart* const> a, std::span<const ExplicitPart* const> b);

}  // namespace desmo
