#pragma once

#include <optional>
#include <span>

#include "cases/mechanism/level.h"
#include "formulations/base/room.h"

namespace desmo {

/// A request: what an analysis is asked for.
struct Request {
  Level level = Level::acceleration;
  /// Coordinates that the observer reads; empty means all. All others are unspecified.
  std::span<const int> coordinates{};
};

/// One instant of a motion. The spans are in coordinate order and valid until the next step; those
/// beyond the requested level are empty.
struct Instant {
  int index;
  double time;  ///< s
  std::span<const double> q, qd, qdd;
  long updates = 0;           ///< that it took: see Summary
  double residual = 0;        ///< ‖Φ‖₂ where it was accepted, as in Summary
  bool interpolated = false;  ///< between those solved (see Settings::stride)
  Room room{};  ///< the observer's own, if the values are there; the spans are then empty

  bool in_room() const { return room.q; }
};

/// Receives the instants of a motion in order of time.
class Observer {
 public:
  virtual ~Observer() = default;
  virtual void observe(const Instant& instant) = 0;
  /// Returns what rooms are for, at an observer that has one for every instant. A solver may put
  /// the values there, which saves a copy, or hand them to observe() all the same.
  virtual std::optional<RoomShape> rooms() const { return {}; }
  /// Gives, at such an observer, a room for each of these instants, which are to come. It is the
  /// solver's until it comes back with its instant. Many may be under way, and come back in any
  /// order; those of a run that is given up do not.
  virtual void take_rooms(std::span<const int> indices, std::span<Room> rooms) {
    static_cast<void>(indices), static_cast<void>(rooms);
  }
  /// Returns whether instants may come in any order, and again, the later then being the one that
  /// holds. A solver of several at once keeps all of them for an observer that needs their order.
  virtual bool takes_any_order() const { return false; }
};

}  // namespace desmo
