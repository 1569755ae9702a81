// results/history.json: instructions of a step of some candidates, commit by commit. Plain data.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace desmo::report {

struct HistoryPoint {
  std::string commit, date, title, compiler;
  /// Instructions of a step, in the order of History::candidates; none: the commit has no count.
  std::vector<std::optional<std::int64_t>> instructions = {};
};

struct History {
  std::vector<std::string> candidates;
  std::vector<HistoryPoint> points;  ///< oldest first
};

/// Reads a file {"schema": 2, "candidates", "points": [{"commit", "date", "subject", "compiler",
/// "instructions"}]}. Throws InputError, naming file and place, or UnreadableFile.
History read_history(const std::filesystem::path& file);

}  // namespace desmo::report
