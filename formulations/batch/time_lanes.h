#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "formulations/base/lane_values.h"
#include "formulations/batch/lane_stage.h"
#include "formulations/batch/segmented.h"
#include "formulations/equations/kernel_table.h"
#include "formulations/equations/lane_kernel.h"
#include "formulations/parts/explicit_part.h"
#include "formulations/prediction/lane_motion.h"
#include "formulations/prediction/predictor.h"

namespace desmo {

/// In instants: entering a shorter segment costs more than the lanes gain.
inline constexpr int min_segment = 16;

/// Runs through a motion in as many equal segments as there are lanes, all of them at once. The
/// first position of a segment is found on the way from that of the motion along which the drivers
/// go straight; that it lies on the same branch shows at the end of the segment before, where both
/// must agree. A part without code for lanes is solved lane by lane, as is a lane that the code
/// refuses.
class TimeLanes final : public SegmentExecutor {
 public:
  using Parts = std::vector<DefinedPart>;

  /// parts: of each lane, the same in all, in the order of solution. table: where code for lanes
  /// is; it must outlive this.
  TimeLanes(const Model& model, std::vector<Parts> parts, const Settings& settings,
            const KernelTable& table);

  /// Nothing where the motion is too short, a segment was not entered or solved, or two did not
  /// meet.
  std::optional<Summary> run(const TimeGrid& grid, const Request& request, State& state,
                             Observer& observer) override;

 private:
  /// A part, and the same part in every lane.
  struct Stage {
    std::vector<Part*> members{};
    std::span<const int> unknowns;
    std::optional<LaneStage> together{};  // nothing: lane by lane
  };
  /// What became of a step in all lanes.
  struct Step {
    bool ok = true;
    int iterations = 0;
    long updates = 0;  // in each lane
  };

  Stage make_stage(std::size_t part, const KernelTable& table) const;
  bool enter(const TimeGrid& grid, int length, const State& first);
  bool enter_together(const TimeGrid& grid, int length, const State& first);
  bool solve_alone(int lane, State& state, std::span<const double> last);
  bool are_assembled() const;
  void pack(int lane, const State& from);
  void take_branches();
  void guess(double h, int known);
  void drive(const TimeGrid& grid, int length, int i);
  Step solve();
  void solve_lane(Stage& stage, int lane, Step& step);
  bool meet() const;
  std::span<const OutputView> borrow(const TimeGrid& grid, int length, int i, Observer& observer);
  Flow deliver(const TimeGrid& grid, int length, int i, Level level, const Step& step,
               Observer& observer);

  const Model& model_;
  const Settings settings_;
  const int lanes_;
  MotionSampler motions_;  // of the drivers, in lanes
  std::vector<Parts> parts_;
  std::vector<Stage> stages_;  // those that move
  Predictor predictor_;  // of unknowns of which a part reads the position, lanes beside each other
  std::vector<int> unwrapped_;  // others that start at their last positions
  LaneState now_, before_;
  LaneValues entered_;                     // positions at the first instant of each segment
  LaneValues residual2_;                   // of the step, by lane
  State alone_;                            // of one lane …
  std::vector<double> last_alone_;         // … and its last positions
  std::vector<std::vector<double>> ways_;  // of the drivers to each segment
  std::vector<int> requested_;             // where requested coordinates begin in lanes
  std::vector<int> indices_;               // of instants for which memory was borrowed …
  std::vector<OutputView> outputs_;        // … and this …
  std::vector<double> beyond_;             // takes what lies after the end of the motion
  std::size_t used_ = 0;                   // … so many of them already
};

}  // namespace desmo
