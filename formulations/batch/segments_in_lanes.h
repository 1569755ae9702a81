#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "formulations/batch/kernel_batch.h"
#include "formulations/equations/kernel_table.h"
#include "formulations/equations/lane_kernel.h"
#include "formulations/motion/prediction/motion_sampler.h"
#include "formulations/motion/segments.h"
#include "formulations/parts/explicit_part.h"

namespace desmo {

/// Minimum length of a segment that is solved in lanes [instants] (≥). In a shorter one, lanes gain
/// less than the continuation to its start costs.
inline constexpr int min_segment = 16;

/// Solves a motion in as many equal segments as there are lanes, one in each lane of a batch of the
/// whole model. A part without code for lanes is solved lane by lane, as is a lane that the code
/// refuses.
class SegmentsInLanes final : public SegmentExecutor {
 public:
  using Parts = std::vector<DefinedPart>;

  /// parts: those of each lane, the same in all, in the order of solution. table: has the code for
  /// lanes. The model and the table outlive this object.
  SegmentsInLanes(const Model& model, std::vector<Parts> parts, const Settings& settings,
                  const KernelTable& table);

  /// Returns nothing where the motion is too short, a segment could not be reached or solved, or
  /// two do not meet.
  std::optional<Summary> run(const TimeGrid& grid, const Request& request, State& state,
                             Observer& observer) override;

 private:
  /// A moving part, with a solver for each lane.
  struct PartInLanes {
    std::vector<std::unique_ptr<Part>> solvers{};
    std::vector<int> unknowns;
    // code for all lanes; nothing: it is solved lane by lane
    std::optional<KernelBatch> together{};
  };
  /// The outcome of a step in all lanes.
  struct StepInLanes {
    bool ok = true;
    int iterations = 0;
    long updates = 0;  // of each lane; leaves out what is solved lane by lane
  };

  PartInLanes put_in_lanes(std::vector<Parts>& parts, std::size_t index,
                           const KernelTable& table) const;
  bool continue_to_segments(const TimeGrid& grid, int length, const State& first);
  bool solve_alone(int lane, State& state, std::span<const double> last);
  void predict(double h, int known);
  void write_drivers(const TimeGrid& grid, int length, int i);
  StepInLanes solve();
  void solve_lane(PartInLanes& part, int lane, StepInLanes& step);
  bool meet() const;
  std::span<const OutputView> borrow(const TimeGrid& grid, int length, int i, Observer& observer);
  void deliver(const TimeGrid& grid, int length, int i, Level level, const StepInLanes& step,
               Observer& observer, Summary& total);

  const Model& model_;
  const int lanes_;
  MotionSampler motions_;  // samples the drivers in lanes
  std::vector<PartInLanes> parts_;
  BatchState state_;
  LaneValues first_positions_;                // positions at the first instant of each segment
  LaneValues residual2_;                      // ‖Φ‖₂² of the step in each lane
  State alone_;                               // workspace: the state of a lane solved alone
  std::vector<double> last_alone_;            // workspace: last positions of that lane
  std::vector<std::vector<double>> changes_;  // changes of the drivers to the start of each segment
  std::vector<int> requested_;  // index in state_ of each requested coordinate, in the first lane
  std::vector<int> indices_;    // indices of the instants for which memory is borrowed
  std::vector<OutputView> outputs_;  // borrowed memory of each instant in indices_
  std::size_t used_ = 0;             // number of outputs_ used so far
  std::vector<double> beyond_;       // receives instants after the end of the motion
};

}  // namespace desmo
