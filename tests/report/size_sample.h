// Synthetic records of time against size and of instructions, and a history.
#pragma once

#include "tests/report/sample.h"

namespace desmo::report {

/// Returns a record of made-up numbers on a machine with L1 10 KiB and L2 100 KiB.
/// - `growth`: group_symbolic_explicit costs 10 ns per coordinate (of 100 bytes) up to 1000
///   coordinates, 15 ns at 10 000, 20 ns at 100 000; global_automatic_klu grows with the square.
/// - `break_even`: dense time is n³; sparse is 3600 n (klu, break-even at 60), 50 n (umfpack) and
///   1e6 n² (cholmod).
Json sizes_record();

/// Returns a record of the experiment modelling: four formulations in each kind of coordinates. By
/// kind, global CHOLMOD takes 1, 2, 3 and 4 times as long as group LAPACK, at the larger of two
/// sizes twice that, and group LAPACK 4 times as long as group KLU.
Json modelling_record();

/// Returns a record with `instructions` of both cases.
Json instructions_record();

/// Returns a history of two candidates, one of which is younger than the first commit and moves by
/// 3 % at the third.
History history_sample();

}  // namespace desmo::report
