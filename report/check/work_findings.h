// What the instruction counts of a check mean, candidate by candidate.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "report/check/check_record.h"
#include "report/check/rules.h"
#include "report/statistics/comparability.h"

namespace desmo::report {

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
