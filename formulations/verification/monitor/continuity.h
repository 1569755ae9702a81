#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "formulations/base/observer.h"
#include "formulations/base/part.h"
#include "formulations/model/model.h"
#include "formulations/verification/assessment/assessor.h"
#include "formulations/verification/monitor/branch_signs.h"
#include "formulations/verification/monitor/driver_turns.h"
#include "formulations/verification/monitor/recent_instants.h"

namespace desmo {

/// Check of whether each instant continues the one before it. It applies the trapezoid rule to the
/// two highest levels solved (q̇ and q̈, or q and q̇). A step is in doubt when the rule is off by
/// more than a fiftieth of a group's movement. A smooth motion is off by (ω h)²/12. It is also in
/// doubt when an angle does not turn as its rates say, but by whole turns more. Such a step is
/// repeated in shorter ones from its beginning, each predicted by a Taylor polynomial. When they do
/// not lead to its end, that lies on another assembly branch.
class Continuity {
 public:
  /// - grid: of the motion; it tells how fast drivers will be
  /// - magnitudes: of each coordinate
  /// - max_steps: largest number of shorter steps in which a step is repeated
  /// The model must outlive this object.
  Continuity(const Model& model, const TimeGrid& grid, std::span<const double> magnitudes,
             int max_steps = 4096);

  /// The means by which a step is judged.
  struct Means {
    Assessor& assessor;  ///< its factors are overwritten
    const Scales& scales;
    /// (coordinates), 1 over the movement when the drivers move by their magnitudes
    /// (SensitivityMonitor).
    const Eigen::ArrayXd& weights;
    const BranchSigns& signs;  ///< of the last assessment
  };

  /// Returns whether the step from the instant taken last is in doubt. min_excursion: how far
  /// drivers may turn beyond this instant before a position may be singular (DriverTurns).
  /// measures: of the step by these weights, where they are known. with_turns: turning points of
  /// the drivers within the step count.
  bool in_doubt(const Instant& instant, const Eigen::ArrayXd& weights, double min_excursion,
                const std::optional<StepMeasures>& measures, bool with_turns = true);
  /// Returns whether all unknown angles turned in that step as their rates say, so closely that
  /// none is half a turn from where they lead.
  bool angles_follow() const { return angles_follow_; }
  /// Prepares the step to an instant whose time is known, and nothing else.
  void expect(const Instant& instant);

  /// Interval in which a step in doubt is not continuous, or passes a singular position.
  struct Jump {
    SingularityCrossing crossing;
    bool at_turn;  ///< where drivers turn: they leave the reach, or pass it there and back
  };
  /// Repeats the step from the instant taken last in shorter ones, through its turning points.
  /// Returns where it jumps, if it does.
  std::optional<Jump> find_jump(const Instant& instant, const Means& means);

  /// Solves an instant anew from the instant taken last, with drivers at its own time, in steps
  /// like those of find_jump(). Returns nothing where rates are not solved or the steps fail. The
  /// result is valid until the next call. known: the level up to which rates lead on; accelerations
  /// above it are unspecified.
  std::optional<Instant> solve_anew(const Instant& instant, const Means& means,
                                    Level known = Level::acceleration);
  /// Returns the crossing, if any, that the steps of the last solve_anew() passed where drivers
  /// turn. Which way the motion goes on there is not known.
  const std::optional<SingularityCrossing>& passed() const { return passed_; }
  /// Returns the instant with its drivers evaluated at its time; valid until the next call.
  Instant driven(const Instant& instant);

  /// The passage of a singular position: an instant there, interpolated between two regular
  /// positions of the motion, one on either side.
  struct Passage {
    Instant instant;                 ///< on the polynomial through q, q̇ and q̈ of both positions
    Instant wide;                    ///< interpolated over a wider interval: shows the error
    double after, before;            ///< times of the two positions [s]
    std::span<const double> beyond;  ///< q of the later position
    Assessment assessment;           ///< of the later position
  };
  /// Passes a singular position at which the motion is smooth. Reaches a regular position before
  /// it, in steps from the instant taken last, and one beyond it by Taylor's polynomial. Tries
  /// nearer positions until the rates of both agree. Returns nothing where rates are not solved, or
  /// none of these positions leads on. The result is valid until the next call.
  std::optional<Passage> pass(const Instant& singular, const Means& means);

  /// Makes this instant the one to continue from; it says what was stated of it.
  void take(const Instant& instant, bool is_assessed, const PerLevel<double>& stated);
  /// Returns the instants taken last.
  RecentInstants& recent() { return recent_; }
  void forget() {
    recent_.forget();
    turns_.forget();
  }
  /// Lets the motion rest at the instant taken last, from where it goes on.
  void rest() {
    if (is_known()) std::ranges::fill(recent_[0].state.qd, 0.0);
    fastest_at_last_ = 0;
  }
  /// Returns whether there is an instant to go on from.
  bool is_known() const { return recent_.count() > 0; }
  /// Counts time from an origin that much earlier [s].
  void shift_time(double by) { recent_.shift_time(by); }

 private:
  using Node = RecentInstants::Node;
  double fastest_driver(const Instant& instant) const;
  double per_movement(const Instant& to, double step, double fastest) const;
  template <class Found>
  auto mismatch(const Instant& from, const Instant& to, const Eigen::ArrayXd& weights,
                Found&& found) const;
  double mismatch(const Instant& from, const Instant& to, const Eigen::ArrayXd& weights) const;
  const Eigen::ArrayXd& position_mismatch(const Instant& from, const Instant& to,
                                          const Eigen::ArrayXd& weights);
  double growth(const Instant& instant, const Eigen::ArrayXd& weights) const;
  void predict(double t, const Instant& like, Assessor& assessor);
  enum class End { given, solved };
  std::optional<Jump> go(const Instant& instant, End end, const Means& means);
  std::optional<Jump> go(const Node& start, const Instant& instant, End end, const Means& means);
  void correct(const Instant& instant, Assessor& assessor, Node& result);
  bool do_angles_follow(const Instant& instant) const;
  bool turns_further(const Instant& from, const Instant& to, const Eigen::ArrayXd& weights) const;
  double moved(const Instant& from, const Instant& to, const Eigen::ArrayXd& weights) const;
  bool leads_on(const Instant& from, const Instant& to, const Eigen::ArrayXd& weights);
  void interpolate(const Node& from, const Node& to, const Instant& like, Node& result) const;

  const Model& model_;
  struct Driven {
    int coordinate;
    double unit;  // 1 / magnitude
  };
  std::vector<GroupId> group_;  // of each coordinate
  std::vector<int> angles_;     // unknown ones
  bool angles_follow_ = false;
  std::vector<Driven> driven_;  // contiguous, since every step reads them
  DriverTurns turns_;           // of the step to the next instant
  double min_excursion_ = 0;    // at the last instant
  double fastest_ = 0;          // largest rate of the drivers so far [magnitudes/s]
  double fastest_at_last_ = 0;  // the same of the last instant
  RecentInstants recent_;
  std::optional<SingularityCrossing> passed_;
  Node reached_, next_, start_, end_;
  std::array<Node, 6> passage_;  // two before, two beyond, two between
  Eigen::ArrayXd turned_;        // position_mismatch()
  int max_steps_;
};

}  // namespace desmo
