// Meaning of a check's times and instruction counts, candidate by candidate.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "report/check/check_record.h"
#include "report/check/rules.h"
#include "report/statistics/comparability.h"

namespace desmo::report {

struct TimeFinding {
  std::string candidate;
  std::string reference;  ///< against a baseline: what its time is divided by; otherwise empty
  double base_seconds = 0, head_seconds = 0;  ///< medians over the rounds; base 0 without one
  Change first;
  std::optional<Change> second;
  Outcome outcome = Outcome::same;
};

struct TimeFindings {
  std::optional<Change> control;  ///< of the first pass; none against a baseline
  std::vector<TimeFinding> candidates;
};

/// Base against head, round by round.
TimeFindings find_times(const CheckRecord& check);

/// Head against that of a stored baseline, by ratios within either run: each candidate's time over
/// that of its case's global_automatic_klu, and that one's over the control. So the speed of the
/// machine and of the day cancel.
TimeFindings find_times(const CheckRecord& check, const CheckRecord& baseline);

struct WorkFinding {
  std::string candidate;
  std::int64_t base = 0, head = 0;  ///< instructions
  double percent = 0;               ///< change, rounded to a tenth
  Outcome outcome = Outcome::same;
};

struct WorkFindings {
  std::vector<Difference> differences;  ///< why the counts cannot be compared; then no candidates
  std::vector<WorkFinding> candidates;  ///< those that both sides have counted
};

/// Base against head, both of the same check.
WorkFindings find_works(const CheckRecord& check);

/// Head against that of a stored baseline. Counts depend on compiler, flags, libraries and tool,
/// but not on the processor: callgrind shows every program the same one.
WorkFindings find_works(const CheckRecord& check, const CheckRecord& baseline);

}  // namespace desmo::report
