#pragma once

#include <span>

#include "cases/mechanism/level.h"
#include "formulations/base/output.h"
#include "formulations/base/per_level.h"

namespace desmo {

/// An instant of a motion. Spans above the requested level are empty. The others hold all
/// coordinates in their order, and are valid until observe() returns. If the observer lends memory,
/// they view that memory, and hold the requested coordinates in the order of the request.
struct Instant {
  int index;    ///< position in the run's grid
  double time;  ///< [s]
  /// Positions (lengths in the model's unit, angles [rad]), velocities (per s), accelerations (per
  /// s²).
  std::span<const double> q, qd, qdd;
  long updates = 0;           ///< work to solve it, counted like BasicSummary::updates
  double residual = 0;        ///< relative ‖Φ‖₂ of the accepted position; 0: interpolated
  bool interpolated = false;  ///< true: not solved (see Settings::stride)
  OutputView output{};        ///< the lent memory, which the observer may lend again
};

/// Returns an instant with index 0 that views `values` up to `level`. time: [s]
inline Instant instant_of(double time, const PerLevel<std::span<const double>>& values,
                          Level level = Level::acceleration) {
  Instant instant{.index = 0, .time = time, .q = values.position, .qd = {}, .qdd = {}};
  if (level >= Level::velocity) instant.qd = values.velocity;
  if (level >= Level::acceleration) instant.qdd = values.acceleration;
  return instant;
}

/// Returns the instant with other values: it views `values` at the levels that it has.
inline Instant with_values(Instant instant, const PerLevel<std::span<const double>>& values) {
  instant.q = values.position;
  if (!instant.qd.empty()) instant.qd = values.velocity;
  if (!instant.qdd.empty()) instant.qdd = values.acceleration;
  return instant;
}

/// Receives the instants of a run. Nothing is thrown through a run: an observer that cannot go on
/// returns Flow::stop and keeps the reason.
///
///   class Peak final : public Observer {
///    public:
///     Flow observe(const Instant& instant) noexcept override {
///       highest = std::max(highest, instant.q[0]);
///       return Flow::go_on;
///     }
///     double highest = -INFINITY;
///   };
class Observer {
 public:
  virtual ~Observer() = default;

  /// Takes an instant of the grid. Each comes once, in order, unless any_order() is true: then in
  /// any order, and again after restart(). Returns whether the run goes on.
  virtual Flow observe(const Instant& instant) noexcept = 0;

  /// Returns for how many instants a call of lend() should ask; it may ask for fewer or more. 0:
  /// the observer lends no memory, and instants come in memory of the solver.
  virtual int lent_at_once() const noexcept { return 0; }
  /// Lends memory for instants to come; called if lent_at_once() is not 0. instants: their indices.
  /// outputs: to be filled, one for each. The solver owns this memory until it hands over the
  /// instant. It does not hand back memory of a run that restarts or ends early.
  virtual void lend(std::span<const int> instants, std::span<OutputView> outputs) noexcept {
    static_cast<void>(instants), static_cast<void>(outputs);
  }

  /// Returns whether instants may come in any order. Segments then arrive as they are solved, if
  /// memory is lent; otherwise the solver keeps the whole motion and hands it over at the end.
  virtual bool any_order() const noexcept { return false; }
  /// Returns the observer that a thread (0, 1, …) calls without a lock; used if any_order().
  /// Several threads may call this at once. Null: all threads call this observer, one call at a
  /// time. restart() is always called on this observer.
  virtual Observer* of_thread(int thread) noexcept {
    static_cast<void>(thread);
    return nullptr;
  }
  /// Tells that all instants so far are void, since segments failed or did not meet: the run begins
  /// again at the first instant. Called only if any_order().
  virtual void restart() noexcept {}
};

}  // namespace desmo
