#pragma once

#include <span>
#include <vector>

#include "formulations/base/resident_part.h"
#include "formulations/batch/batch.h"
#include "formulations/equations/kernel_table.h"
#include "formulations/model/partition.h"

namespace desmo {

/// Equal subsystems, none of which needs another, solved in batches by explicit code on wide
/// registers. A subsystem is one part, or several whose results stay in lanes. A subsystem is
/// solved alone, by its own parts, while it has no position yet and where the code refuses one of
/// its parts.
class BatchPart final : public Part, public ResidentPart {
 public:
  /// - kernels: those of a subsystem for each number of lanes, ascending; at least one
  /// - subsystems: two or more, alike as are_alike() says
  /// - kinds: the origin of each position in the state
  BatchPart(std::vector<SubsystemKernels> kernels, std::vector<Subsystem> subsystems,
            const std::vector<StateKind>& kinds, Guess guess);

  PartResult solve(State& state, std::span<const double> last, Level level) override;
  /// Returns drivers and other inputs of the batches, and all inputs of the subsystem that is left
  /// over, its own unknowns included. Only that subsystem has predicted unknowns: batches predict
  /// from what they keep.
  PartInputs inputs(PartInputs equations) const override;
  ResidentPart* resident() override { return this; }
  void bind(const PartOutputs& outputs) override;
  void begin_step(const StepHistory& history, const MotionRow& row) override;
  void deliver(const OutputView& output, Level level) const override;
  void store(State& state) const override;
  void restore(std::span<double> q) const override;
  void forget() override;

  /// Returns the sums over the parts of all subsystems.
  PartCounts counts() const override;

 private:
  void solve(Batch& batch, State& state, std::span<const double> last, Level level,
             PartResult& all);
  static void solve_alone(Subsystem& subsystem, State& state, std::span<const double> last,
                          Level level, PartResult& all);

  std::vector<Subsystem> subsystems_;
  std::vector<Batch> batches_;
  Subsystem* left_over_ = nullptr;  // subsystem that would be alone in a batch; null: none
  std::vector<double> last_;  // workspace: last positions for subsystems that are solved alone
};

/// Joins parts in explicit order to batches of up to settings.lanes. A batch has equal subsystems
/// that need nothing of each other. Where that takes fewer calls of kernels, it has parts of one
/// type that do not need each other. type_ends: the end of each range of such parts (see
/// gather_types). Parts without code for lanes stay alone.
std::vector<DefinedPart> make_batches(const Model& model, std::vector<DefinedPart> parts,
                                      const std::vector<int>& type_ends, const Settings& settings,
                                      const KernelTable& table);

}  // namespace desmo
