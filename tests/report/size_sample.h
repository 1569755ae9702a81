// Synthetic records of time against size, and of instructions.
#pragma once

#include "tests/report/sample.h"

namespace desmo::report {

/// An "ok" element of `growth` or `crossing` whose least sample is so many µs.
Json timed_size(const std::string& case_name, int coordinates, const std::string& id,
                double microseconds);

/// `growth`: group_symbolic_explicit costs 10 ns a coordinate of 100 bytes up to 1000 coordinates,
/// 15 at 10 000 and 20 at 100 000; global_automatic_klu grows with the square. `crossing`: dense
/// time is n³, sparse 3600 n (klu: they meet at 60), 50 n (umfpack), and 1e6 n² (cholmod). Of a
/// machine with L1 10 KiB and L2 100 KiB. Made-up numbers.
Json sizes_record();

/// `instructions` of both cases.
Json instructions_record();

}  // namespace desmo::report
