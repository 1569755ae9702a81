// Whether an answer is right: what a record says of it. Plain data.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace desmo::report {

enum class Status { ok, failed, not_run };

/// Largest absolute differences from the quadruple-precision reference.
struct Verification {
  std::int64_t instants = 0;
  double position = 0;
  double velocity = 0;
  double acceleration = 0;
};

/// Largest differences from the reference that a verification may find.
struct Allowed {
  double position = 0;
  double velocity = 0;
  double acceleration = 0;
  std::optional<double> request;  ///< of a request from the whole mechanism
};

/// "velocity differs by 2e-06, 1e-08 is allowed"; empty when it is allowed.
std::string excess(const std::string& what, double difference, double limit);
std::string excess(const Verification& found, const Allowed& allowed);

}  // namespace desmo::report
