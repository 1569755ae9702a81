#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "bench/kit/process/child.h"

namespace desmo::regression {

/// Settings with which the time of a candidate is measured.
struct TimingSettings {
  static constexpr int instants = 51;    ///< number of instants of an analysis, 10 ms apart
  static constexpr int rounds = 25;      ///< number of rounds; odd, so that one is the median
  static constexpr int turns = 3;        ///< turns of each side with a candidate in a round
  static constexpr int repetitions = 2;  ///< analyses in a turn, after one to warm up
};

/// Settings with which the instructions of a candidate are counted.
struct CountingSettings {
  static constexpr int steps = 105;  ///< number of steps, uncounted ones included
  /// Number of first steps that are not counted. They choose pivots and bring positions near the
  /// solution (see desmo_steps).
  static constexpr int uncounted_steps = 5;
  static constexpr int iterations = 3;  ///< number of Newton–Raphson iterations in every step
};

/// A side: one of the two trees that are compared.
struct Side {
  std::string name;    ///< "base" or "head"
  std::string folder;  ///< folder of its desmo_probe and desmo_steps
  std::string slowed;  ///< the candidate made slower on purpose; empty: none
  int percent = 0;     ///< percentage by which it is slower

  /// Returns environment and arguments of `desmo_probe ...`, which are the same on both sides.
  bench::Launch probe(std::vector<std::string> arguments) const;
};

/// Name of the fixed kernel that is timed like a candidate in every round. The report reads the
/// same one (report/check/check_record.h).
inline constexpr const char* control_name = "control";

/// Least CPU time [s] of each candidate, and of the control, on each side, by round.
using Times = std::map<std::string, std::map<std::string, std::vector<double>>>;

/// Times candidates on one or two sides, in `count` rounds. In each round every side runs in a new
/// process, because the place of a build in memory changes its times. All processes of a round
/// share one core; the next round takes the next core in turn. Candidates come in random order; for
/// each, the sides take turns in random order, each turn with newly placed data. Throws
/// std::runtime_error when a side does not answer.
Times time_rounds(const std::vector<Side>& sides, std::vector<std::string> names, int count,
                  std::uint64_t seed);

}  // namespace desmo::regression
