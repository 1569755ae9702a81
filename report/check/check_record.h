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

/// Name of the control: a fixed kernel that is timed like a candidate, so that its times show
/// changes of the machine.
inline constexpr const char* control_name = "control";

/// Times of a candidate or of the control: the least CPU time [s] of each round. Base and head have
/// equally many rounds.
struct Rounds {
  std::vector<double> base, head;
};

/// Numbers of instructions of a candidate's counted steps.
struct Instructions {
  std::optional<std::int64_t> base;  ///< none when head was counted alone
  std::int64_t head = 0;
};

/// Counts of instructions. Two of them are comparable only with the same tool, steps and
/// iterations.
struct Work {
  std::string tool;                        ///< counting program, and versions that counts depend on
  std::int64_t steps = 0, iterations = 0;  ///< number of steps counted, and of iterations in each
  std::map<std::string, Instructions> instructions;  ///< by name_of() the candidate
};

/// A check: two trees, base and head, that were timed, counted or both; or head, counted alone.
struct CheckRecord {
  std::optional<Record> base;  ///< none when head was counted alone
  Record head;                 ///< its samples are those of the first pass, one for each round
  Rounds control;              ///< times of the control in the first pass
  /// Times of the second pass, by name_of() the candidate, and by control_name; may be empty.
  std::map<std::string, Rounds> second;
  std::optional<Work> work;  ///< none: nothing was counted
  std::string slowed;  ///< what was made slower on purpose, SIDE:CANDIDATE:PERCENT; empty: nothing
};

/// Tells whether any candidate of a side has times.
bool has_times(const Record& side);

/// Parses a check and checks all that a verdict relies on. Both sides are records and have the same
/// candidates. A candidate that is right on both has times where any has, and counts where any has.
/// Throws InputError, naming the place, UnsupportedVersion or MixedRecord.
CheckRecord parse_check(std::string_view text, const std::string& file = "check");

/// Reads and parses a file, plain or gzip. Throws as parse_check(), or UnreadableFile.
CheckRecord read_check(const std::filesystem::path& file);

}  // namespace desmo::report
