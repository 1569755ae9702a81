#pragma once

#include <array>

namespace desmo::regression {

/// What bench/check measures: every partition, evaluation and algebra at least once, each at a size
/// that takes about a millisecond. Left out are the four-bar's groups of two unknowns with LAPACK
/// or Eigen: calls are most of their time, and it changes by 5 % with the alignment of code alone.
inline constexpr std::array checked_cells{
    "four_bar/114/global_automatic_klu",
    "four_bar/114/group_symbolic_inlined",
    "four_bar/54/block_symbolic_klu",
    "four_bar/24/global_automatic_lapack",
    "four_bar/24/global_symbolic_umfpack",
    "truck_suspension/114/global_automatic_klu",
    "truck_suspension/114/global_symbolic_cholmod",
    "truck_suspension/114/group_automatic_cholmod",
    "truck_suspension/114/group_automatic_spqr",
    "truck_suspension/114/group_automatic_sparselu",
    "truck_suspension/114/group_symbolic_klu",
    "truck_suspension/114/group_symbolic_eigen",
    "truck_suspension/114/group_symbolic_lapack",
    "truck_suspension/114/group_symbolic_explicit",
    "truck_suspension/114/block_symbolic_inlined",
};

/// How the time of a cell is measured.
inline constexpr int instants = 51;    ///< of one analysis, 10 ms apart
inline constexpr int rounds = 25;      ///< each with processes of its own; odd, so has a median
inline constexpr int turns = 3;        ///< of base and head with a cell in a round
inline constexpr int repetitions = 2;  ///< of the analysis in a turn, after one to warm up

/// How its instructions are counted.
inline constexpr int steps = 105;
inline constexpr int uncounted_steps = 5;  ///< the first of them (see desmo_steps)
inline constexpr int iterations = 3;       ///< of Newton–Raphson in every step

}  // namespace desmo::regression
