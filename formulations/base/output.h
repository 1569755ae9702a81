#pragma once

#include <span>

#include "cases/mechanism/level.h"

namespace desmo {

/// A request: the results that a run is to deliver.
struct Request {
  Level level = Level::acceleration;  ///< highest level requested
  /// Coordinates to deliver, each once; empty means all. All others are unspecified.
  std::span<const int> coordinates{};
};

/// Memory that an observer lends for one instant: arrays of the requested coordinates, in the order
/// of the request. Null: the level is not wanted. Nothing is written above the requested level.
struct OutputView {
  double *q = nullptr, *qd = nullptr, *qdd = nullptr;
};

/// The answer of an observer: whether the run goes on.
enum class Flow { go_on, stop };

}  // namespace desmo
