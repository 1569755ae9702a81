// The table of extremes as a record holds it: plain data.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace desmo::report {

struct ExtremeRow {
  std::int64_t number = 0;
  std::string name;               ///< short
  std::string extreme, expected;  ///< what is extreme, and what every formulation should do
};

/// The worst error of a level, beside the floor that conditioning sets and what was allowed.
struct ExtremeError {
  double error = 0, floor = 0, allowed = 0;
};

/// A case of a row in one formulation.
struct ExtremeResult {
  enum class Verdict {
    as_expected,
    missed,  ///< less than expected, and no wrong number without a flag
    defect,  ///< wrong numbers, or numbers where there is no answer, without a flag
    not_applicable,
  };
  std::int64_t row = 0;
  std::string case_name;
  std::string id;       ///< a formulation, with settings
  std::string outcome;  ///< "converged", "degraded", "failed", "refused", "not_applicable"
  Verdict verdict = Verdict::as_expected;
  std::string reason;                                ///< when not as expected
  std::optional<std::array<ExtremeError, 3>> worst;  ///< position, velocity, acceleration
  std::int64_t instants = 0, iterations = 0;         ///< 0: not tried
};

}  // namespace desmo::report
