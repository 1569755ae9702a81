#pragma once

namespace desmo::regression {

/// Settings with which the time of a candidate is measured.
inline constexpr int instants = 51;    ///< of one analysis, 10 ms apart
inline constexpr int rounds = 25;      ///< each with processes of its own; odd, so has a median
inline constexpr int turns = 3;        ///< of base and head with a candidate in a round
inline constexpr int repetitions = 2;  ///< of the analysis in a turn, after one to warm up

/// Settings with which its instructions are counted.
inline constexpr int steps = 105;
inline constexpr int uncounted_steps = 5;  ///< the first of them (see desmo_steps)
inline constexpr int iterations = 3;       ///< of Newton–Raphson in every step

}  // namespace desmo::regression
