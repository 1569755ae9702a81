// The results file of a check, as results/check.schema.json defines it: plain data.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "report/read/record.h"

namespace desmo::report {

/// Name of the fixed kernel that is timed like a candidate.
inline constexpr const char* control_name = "control";

/// The least CPU seconds of a candidate in each round.
struct Rounds {
  std::vector<double> base,
      head;  ///< as many of either; base is empty when head was measured alone
};

/// Instructions of a candidate's counted steps.
struct Instructions {
  std::optional<std::int64_t> base, head;
};

struct Work {
  std::string tool;
  std::int64_t steps = 0, iterations = 0;  ///< of which the counts are; equal work needs equal ones
  std::map<std::string, Instructions> instructions;  ///< by candidate
};

struct CheckRecord {
  std::optional<Record> base;  ///< none when head was measured alone
  Record head;                 ///< samples: the first pass, a value a round
  Rounds control;              ///< likewise
  std::map<std::string, Rounds>
      second;  ///< pass that confirms the first, by candidate, with the control
  std::optional<Work> work;
  std::string slowed;  ///< what was made slower on purpose, SIDE:CELL:PERCENT; empty: nothing
};

}  // namespace desmo::report
