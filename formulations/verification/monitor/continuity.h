#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "formulations/base/observer.h"
#include "formulations/base/part.h"
#include "formulations/model/model.h"
#include "formulations/verification/assessment/assessor.h"

namespace desmo {

/// Check of whether each instant continues the one before it. It applies the trapezoid rule to the
/// two highest levels solved (q̇ and q̈, or q and q̇). A step is in doubt when the rule is off by
/// more than a fiftieth of a group's movement. A smooth motion is off by (ω h)²/12. Such a step is
/// repeated in shorter ones from its beginning, each predicted by a Taylor polynomial. When they do
/// not lead to its end, that lies on another assembly branch.
class Continuity {
 public:
  /// grid: of the motion, which tells how fast drivers will be. magnitudes: of each coordinate.
  /// max_steps: shorter steps that one is gone again in. The mechanism must outlive it.
  Continuity(const Model& model, const TimeGrid& grid, std::span<const double> magnitudes,
             int max_steps = 4096);

  /// Returns whether the step from the instant taken last is in doubt. weights: (coordinates), 1
  /// over the movement when the drivers move by their magnitudes (SensitivityMonitor).
  bool in_doubt(const Instant& instant, const Eigen::ArrayXd& weights) const;

  /// Interval in which a step in doubt is not continuous.
  struct Jump {
    double after, before;  ///< [s]
    int coordinate;        ///< the one that jumps most
  };
  /// Repeats the step from the instant taken last in shorter ones. Returns where it jumps, if it
  /// does. Overwrites the assessor's factors.
  std::optional<Jump> find_jump(const Instant& instant, const Eigen::ArrayXd& weights,
                                Assessor& assessor);

  /// Solves an instant anew from the instant taken last, with drivers at its own time, in steps
  /// like those of find_jump(). Returns nothing where rates are not solved or the steps fail. The
  /// result is valid until the next call. Overwrites the assessor's factors.
  std::optional<Instant> solve_anew(const Instant& instant, const Eigen::ArrayXd& weights,
                                    Assessor& assessor);
  /// Returns the instant with its drivers evaluated at its time; valid until the next call.
  Instant driven(const Instant& instant);

  /// Makes this instant the one to continue from.
  void take(const Instant& instant);
  void forget() { known_ = false; }
  /// Returns whether there is an instant to go on from.
  bool is_known() const { return known_; }
  /// Counts time from an origin that much earlier [s].
  void shift_time(double by) { last_.time += by; }

 private:
  /// Copy of an instant.
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
    double unit;  // 1 / magnitude
  };
  std::vector<Driven> driven_;  // contiguous, since every step reads them
  bool known_ = false;
  double fastest_ = 0;  // largest rate of the drivers so far [magnitudes/s]
  Node last_, reached_, next_;
  Eigen::ArrayXd turned_;  // position_mismatch()
  int max_steps_;
};

}  // namespace desmo
