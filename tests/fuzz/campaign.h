#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/fuzz/mutator.h"
#include "tests/fuzz/trial.h"

namespace desmo::fuzz {

// A *campaign* tries many mutated files. A *finding* is behaviour that no input may cause
// (trial.h).

/// The settings of a campaign.
struct Options {
  std::uint64_t seed = 1;
  long first = 0, inputs = 10'000;
  std::filesystem::path corpus;  ///< folder
  std::filesystem::path save;    ///< folder for inputs that cause findings; empty: none are saved
  bool progress = false;         ///< prints progress on standard error
};

/// The result of a campaign.
struct Campaign {
  struct Kind {
    std::vector<long> inputs;  ///< in order
    std::string detail;        ///< text of the finding of the first one
  };
  std::array<long, outcome_names.size()> outcomes{};  ///< number of inputs by TrialOutcome
  std::map<std::string, Kind> findings;               ///< by class
};

/// Returns input i of a seed. It depends on seed and i alone.
std::string make_input(const std::vector<Sample>& corpus, std::uint64_t seed, long i);

/// Tries inputs first … first + inputs - 1 in child processes. A crash, an endless loop or a
/// sanitizer's report is a finding and does not end the campaign.
Campaign run(const Options& options);

/// Tries one text with every formulation, in child processes.
Campaign replay(const std::string& text, const std::filesystem::path& folder);

/// Returns a campaign's result as text.
std::string report(const Campaign& campaign);

}  // namespace desmo::fuzz
