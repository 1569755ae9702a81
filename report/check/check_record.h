// The results file of a check, as results/check.schema.json defines it: plain data.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "report/read/record.h"
#include "report/read/record_file.h"

namespace desmo::report {

/// Name of the fixed kernel that is timed like a candidate.
inline constexpr const char* control_name = "control";

/// The least CPU seconds of a candidate in each round, as many on either side.
struct Rounds {
  std::vector<double> base, head;
};

/// Instructions of a candidate's counted steps.
struct Instructions {
  std::optional<std::int64_t> base;  ///< none when head was counted alone
  std::int64_t head = 0;
};

struct Work {
  std::string tool;
  std::int64_t steps = 0, iterations = 0;  ///< steps counted, and iterations in each; counts
                                           ///< compare where both are equal
  std::map<std::string, Instructions> instructions;  ///< by candidate
};

struct CheckRecord {
  std::optional<Record> base;  ///< none when head was counted alone: nothing is timed then
  Record head;                 ///< samples: the first pass, a value a round
  Rounds control;              ///< times of the fixed kernel in the first pass
  std::map<std::string, Rounds>
      second;  ///< pass that confirms the first, by candidate, with the control
  std::optional<Work> work;
  std::string slowed;  ///< what was made slower on purpose, SIDE:CANDIDATE:PERCENT; empty: nothing
};

/// Tells whether a side has times, of any candidate.
bool has_times(const Record& side);

/// Checks everything that a verdict relies on: that both sides have the same candidates, and that
/// what is right on both was measured by all that was used, Time, Work or both. The two sides are
/// records of their own, read as such. Throws InputError, naming the place; UnsupportedVersion
/// and MixedRecord where they apply.
CheckRecord parse_check(std::string_view text, const std::string& file = "check");

/// Throws as parse_check, or UnreadableRecord.
CheckRecord read_check(const std::filesystem::path& file);

}  // namespace desmo::report
