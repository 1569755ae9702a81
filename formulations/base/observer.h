#pragma once

#include <span>

#include "cases/mechanism/level.h"
#include "formulations/base/output.h"

namespace desmo {

/// An instant of a motion. The spans are valid until the next instant comes; those beyond the
/// requested level are empty. They hold all coordinates in their order, or, at an observer that
/// lends memory, the requested ones, in that memory.
struct Instant {
  int index;
  double time;  ///< [s]
  std::span<const double> q, qd, qdd;
  long updates = 0;           ///< that it took: see Summary
  double residual = 0;        ///< ‖Φ‖₂ where it was accepted, as in Summary
  bool interpolated = false;  ///< between those solved (see Settings::stride)
  OutputView output{};        ///< the lent memory, which the observer may lend again
};

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

  /// Takes an instant: in order of time, each once, unless any_order() allows others. Returns
  /// whether the run goes on.
  virtual Flow observe(const Instant& instant) noexcept = 0;

  /// Returns for how many instants the observer lends memory at a time. 0: it lends none, and
  /// instants come in memory of the solver.
  virtual int lent_at_once() const noexcept { return 0; }
  /// Lends memory for instants to come, asked of an observer whose lent_at_once() is not 0. Every
  /// instant then comes in memory that was lent for it, which is the solver's until that moment.
  /// Memory of a run that restarts or ends early does not come back.
  virtual void lend(std::span<const int> instants, std::span<OutputView> outputs) noexcept {
    static_cast<void>(instants), static_cast<void>(outputs);
  }

  /// Returns whether instants may come in any order. A solver of several at once hands these over
  /// as they are solved where memory is lent for them, and keeps all of them otherwise.
  virtual bool any_order() const noexcept { return false; }
  /// Returns the observer that a thread (0, 1, …) uses on its own, without a lock, at an observer
  /// that takes any order; several threads ask at once. Null: all share this one, one call at a
  /// time. restart() is told to this one alone.
  virtual Observer* of_thread(int thread) noexcept {
    static_cast<void>(thread);
    return nullptr;
  }
  /// Tells that all instants so far are void: the run begins again at the first, for segments that
  /// were solved at once do not meet. Asked of an observer that takes any order.
  virtual void restart() noexcept {}
};

}  // namespace desmo
