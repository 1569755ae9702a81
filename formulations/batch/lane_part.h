#pragma once

#include <span>
#include <vector>

#include "formulations/batch/lane_batch.h"
#include "formulations/parts/guarded_part.h"

namespace desmo {

/// Copies of one and the same piece of a mechanism, none of which needs another, solved several at
/// once by explicit code on wide registers: parts of one type, or each copy several parts, whose
/// results stay in lanes. A copy that has no position yet, or of which the code refuses a part, is
/// solved alone, by its own parts.
class LanePart final : public GuardedPart {
 public:
  /// kernels: one or more, each for more lanes than the one before. copies: two or more, as alike
  /// as are_copies() says. kinds: of each position in the state. guess: from which a step starts.
  LanePart(std::vector<CopyKernels> kernels, std::vector<Copy> copies,
           const std::vector<StateKind>& kinds, Guess guess);

  PartResult solve(State& state, std::span<const double> last, Level level) override;
  /// Predicted are those of the copy that is left over, if one is: what is kept starts from there.
  PartInputs inputs(PartInputs equations) const override;
  bool is_resident() const override { return true; }
  void bind(const PartOutputs& outputs) override;
  void begin_step(const StepHistory& history, const MotionRow& row) override;
  void deliver(const OutputView& output, Level level) const override;
  void store(State& state) const override;
  void restore(std::span<double> q) const override;
  void forget() override;

  /// Of its members.
  long fallbacks() const override;
  long branch_changes() const override;

 private:
  /// Of several copies or parts.
  struct Result {
    PartResult all;
    void add(const PartResult& one);
  };
  void solve(LaneBatch& batch, State& state, std::span<const double> last, Level level,
             Result& result);
  static void solve_alone(Copy& copy, State& state, std::span<const double> last, Level level,
                          Result& result);

  std::vector<Copy> copies_;
  std::vector<LaneBatch> batches_;
  Copy* left_over_ = nullptr;  // a copy that would be alone in a batch
  std::vector<double> last_;   // positions of the instant before, where a copy is solved alone
};

}  // namespace desmo
