#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "cases/mechanism/motion.h"
#include "formulations/base/observer.h"
#include "formulations/base/part.h"
#include "formulations/model/model.h"
#include "formulations/scaling/scales.h"
#include "formulations/verification/monitor/assessment.h"
#include "formulations/verification/monitor/crossing.h"

namespace desmo {

/// What makes a watch assess an instant, and what it looks at when it does.
enum class Monitor : unsigned {
  sensitivity = 1,   ///< rates of unknowns over those of the drivers; at looks, of anything
  residual = 2,      ///< ‖Φ‖ at which positions were accepted
  clock = 4,         ///< so many instants since the last; looks at what rates may not show
  bounds = 8,        ///< degraded and singular instants are told from others
  orientation = 16,  ///< signs of the determinants of irreducible blocks
  continuity = 32    ///< whether rates lead from each instant to the next (Continuity)
};

struct MonitorName {
  Monitor monitor;
  std::string_view name;
};
inline constexpr std::array monitor_names{
    MonitorName{Monitor::sensitivity, "sensitivity"},
    MonitorName{Monitor::residual, "residual"},
    MonitorName{Monitor::clock, "clock"},
    MonitorName{Monitor::bounds, "bounds"},
    MonitorName{Monitor::orientation, "orientation"},
    MonitorName{Monitor::continuity, "continuity"},
};

/// How right the instants of a motion are, at little cost: one is assessed (Assessor) when it is
/// the first or the clock has come round, and when a cheap signal has moved by a factor of four
/// since the last assessment, or by less where what is expected of it (Expectation) is worth
/// correcting:
///
///   gain       the largest rate of an unknown of a group over that of the drivers; it grows as
///              the condition number does, which is the inverse of the distance to a dead point,
///              unless the motion happens not to show it (ConditionMonitor)
///   residual   ‖Φ‖, to which the error of position is proportional; where pivots are reused, what
///              Φ̇ and Φ̈ are off by as well (BackwardError)
///
/// Interpolated instants are judged by what Φ, Φ̇ and Φ̈ are off by; what exceeds the limits of
/// *degraded* is solved from the instant before. What is stated of an instant that is not assessed
/// never exceeds these limits: otherwise it is assessed.
///
/// An instant whose bounds exceed 10 times the tolerance in position, 10² and 10³ times in velocity
/// and acceleration (as a condition number's powers go), and ten times what conditioning allows
/// (accuracy_limit), is corrected with factors of its own position and assessed again. What is
/// above 100, 100² and 100³ times the tolerance then is *degraded*: conditioning allows no better.
/// The instant after it is assessed as well, until one is not degraded.
class Watch {
 public:
  static constexpr int usual = 2000;

  struct Options {
    double tolerance = default_tolerance;  ///< that positions are solved to
    std::span<const Level> levels{};       ///< as far as each coordinate is solved (Plan::levels)
    int every = usual;                     ///< instants from one assessment to the next, at most
    bool reuses_pivots = false;            ///< rates may come from pivots of another position
    unsigned without = 0;                  ///< monitors left out, for tests of what each finds
    std::optional<Scales> scales{};        ///< that bounds are relative to; empty: of the motion
    int max_steps = 4096;          ///< shorter steps in which one that is in doubt is gone again
    int max_degradations = 10000;  ///< that are looked at again when scales grow
  };

  /// grid: of the motion, whose drivers tell how fast it will be. The mechanism must outlive the
  /// watch.
  Watch(const Model& model, const TimeGrid& grid, const Options& options);
  ~Watch();

  struct Judgement {
    Instant instant;  ///< corrected, perhaps; valid until the next
    bool degraded = false;
    bool solved_anew = false;  ///< it was interpolated, and that was not good enough
    std::optional<Crossing> crossing{};
    Assessment assessment{};  ///< of this instant, or a guess after the last one assessed
  };
  /// Instants in order of time. Nothing is taken from the heap but by KLU, and for
  /// degraded instants.
  Judgement judge(const Instant& instant);

  /// The next instant does not follow the last: it is assessed.
  void resume();

  /// Takes the step to the next instant for one in doubt: it is gone again, and assessed.
  void doubt_next();
  /// Counts time from an origin that much earlier [s].
  void shift_time(double by);

  /// Instants assessed and corrected.
  long assessed() const;
  long corrected() const;
  /// The largest condition number and bounds so far, relative to the motion so far: of all
  /// instants, those between assessments by their signals.
  double condition() const;
  const PerLevel<double>& bound() const;
  /// Instants that are degraded relative to the motion so far, and the first of them: what rates
  /// were at rest, early in a motion, may have been rounding compared with what they became.
  long degraded() const;
  std::optional<Degradation> first_degraded() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace desmo
