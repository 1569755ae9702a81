#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/experiments/promise/run_verdict.h"

namespace desmo::promise {

/// Returns the ids in which every scene is solved, in a fixed order: all variants of this build
/// with the paper's settings, and 54 of other settings.
std::vector<std::string> canonical_ids();

/// Result of a scene: a line of the progress file.
struct SceneResult {
  int number = -1;
  std::string family = {}, aim = {};
  std::string verdicts = {};  ///< a letter for each canonical id (verdict_letters)
  /// The worst wrong number, and the first flag without a cause, with their ids.
  struct Finding {
    std::string id;
    RunVerdict details;
  };
  std::optional<Finding> wrong = {}, flag = {};
  std::string failure = {};  ///< why no scene could be drawn
};

/// Draws a scene and judges it in every id.
SceneResult run_scene(std::uint64_t seed, int number, const std::vector<std::string>& ids);

/// Returns a result as JSON.
nlohmann::ordered_json to_json(const SceneResult& result);
/// Returns the result that to_json() wrote.
SceneResult from_json(const nlohmann::ordered_json& json);

/// Numbers of each verdict, in the order of `verdict_letters`.
using Counts = std::array<long, verdict_letters.size()>;

/// Counts of all scenes, by what they have in common.
struct Tally {
  Counts all{};
  std::map<std::string, Counts> by_family, by_aim, by_id;
  long scenes = 0, not_drawn = 0;
};
Tally tally(const std::vector<SceneResult>& results, const std::vector<std::string>& ids);

/// Returns the scenes with wrong numbers, the most wrong ids first, then those with most false
/// flags; at most `count`.
std::vector<SceneResult> worst(std::vector<SceneResult> results, std::size_t count);

/// Returns the lists of the record: counts, and the worst scenes.
nlohmann::ordered_json record_lists(const std::vector<SceneResult>& results,
                                    const std::vector<std::string>& ids);

/// Writes counts and the worst scenes for people, with commands that reproduce them.
void print(std::ostream& out, const std::vector<SceneResult>& results,
           const std::vector<std::string>& ids, std::uint64_t seed);

}  // namespace desmo::promise
