// Time against size, as a record holds it: plain data.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "report/read/verification.h"

namespace desmo::report {

/// A formulation at one size of a case.
struct TimedSize {
  Status status = Status::failed;  ///< ok or failed
  std::string message;             ///< why it failed
  std::int64_t unknowns = 0;
  double tolerance = 0;
  std::string checked_against;  ///< "quadruple", "double": the reference's precision; when ok
  std::optional<Verification> verification;  ///< always when ok
  double iterations_per_step = 0;
  double state_bytes = 0;       ///< q, q', q''
  std::optional<double> bytes;  ///< that the formulation keeps in memory
  /// Samples of CPU time; never empty when ok, always when not.
  std::vector<double> seconds_per_step;
};

}  // namespace desmo::report
