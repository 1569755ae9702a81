#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "formulations/base/observer.h"
#include "formulations/base/part.h"
#include "formulations/model/model.h"
#include "formulations/verification/monitor/assessor.h"

namespace desmo {

/// Whether each instant goes on continuously from the one before it. In doubt is a step over which
/// the trapezoid rule between the two highest levels solved, q̇ and q̈ or q and q̇, is off by more
/// than a fiftieth of what a group moves: a smooth motion is off by (ω h)²/12. Such a step is gone
/// again in as many shorter ones as it takes, from its beginning, each from where Taylor's
/// polynomial leads: an end that they do not lead to lies on another assembly branch.
class Continuity {
 public:
  /// grid: of the motion, which tells how fast drivers will be. magnitudes: of each coordinate.
  /// max_steps: shorter steps that one is gone again in. The mechanism must outlive it.
  Continuity(const Model& model, const TimeGrid& grid, std::span<const double> magnitudes,
             int max_steps = 4096);

  /// Whether the step from the instant taken last is in doubt. weights: of each coordinate, 1 over
  /// what it moves when the drivers move by their magnitudes (SensitivityMonitor).
  bool in_doubt(const Instant& instant, const Eigen::ArrayXd& weights) const;

  /// Where a step that is in doubt is not continuous.
  struct Jump {
    double after, before;  ///< s
    int coordinate;        ///< that jumps most
  };
  /// Goes the step from the instant taken last again. Overwrites what the assessor has factorised.
  std::optional<Jump> find_jump(const Instant& instant, const Eigen::ArrayXd& weights,
                                Assessor& assessor);

  /// An instant solved anew, with its own drivers, from the instant taken last on, in steps as
  /// find_jump() takes them. Nothing where rates are not solved, or no such way is found. Valid
  /// until the next call; overwrites what the assessor has factorised.
  std::optional<Instant> solve_anew(const Instant& instant, const Eigen::ArrayXd& weights,
                                    Assessor& assessor);
  /// An instant with the drivers of its own time. Valid until the next call.
  Instant driven(const Instant& instant);

  /// The instant is the one to go on from.
  void take(const Instant& instant);
  void forget() { known_ = false; }
  /// Returns whether there is an instant to go on from.
  bool is_known() const { return known_; }
  /// Counts time from an origin that much earlier [s].
  void shift_time(double by) { last_.time += by; }

 private:
  /// An instant of its own.
  struct Node {
    double time = 0;
    State state;
    void take(const Instant& instant);
  };
  double fastest_driver(const Instant& instant) const;
  template <class Found>
  auto mismatch(const Instant& from, const Instant& to, const Eigen::ArrayXd& weights,
                Found&& found) const;
  double mismatch(const Instant& from, const Instant& to, const Eigen::ArrayXd& weights) const;
  const Eigen::ArrayXd& position_mismatch(const Instant& from, const Instant& to,
                                          const Eigen::ArrayXd& weights);
  double growth(const Instant& instant, const Eigen::ArrayXd& weights) const;
  Instant view(const Node& node, const Instant& like) const;
  void predict(double t, const Instant& like, Assessor& assessor);
  enum class End { given, solved };
  std::optional<Jump> go(const Instant& instant, End end, const Eigen::ArrayXd& weights,
                         Assessor& assessor);

  const Model& model_;
  struct Driven {
    int coordinate;
    double unit;  // 1 over its magnitude
  };
  std::vector<Driven> driven_;  // side by side, for they are looked at in every step
  bool known_ = false;
  double fastest_ = 0;  // of the drivers, magnitudes over s
  Node last_, reached_, next_;
  Eigen::ArrayXd turned_;  // position_mismatch()
  int max_steps_;
};

}  // namespace desmo
