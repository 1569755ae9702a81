#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/fuzz/corpus.h"
#include "tests/fuzz/trial.h"

namespace desmo::fuzz {

struct Options {
  std::uint64_t seed = 1;
  long first = 0, inputs = 10'000;
  std::filesystem::path corpus;  ///< folder
  std::filesystem::path save;    ///< folder for the inputs of findings; empty: they are not kept
  bool progress = false;         ///< now and then a line on standard error
};

struct Campaign {
  struct Kind {
    long count = 0;
    long first = 0;      ///< index of the first input
    std::string detail;  ///< of that
  };
  std::array<long, outcome_names.size()> outcomes{};
  std::map<std::string, Kind> findings;  ///< by class
  double slowest = 0;                    ///< s of CPU, of one input
  long slowest_input = 0;
};

/// Input number i of a seed, whatever the inputs before it, and the formulation it is solved with.
std::string make_input(const std::vector<Sample>& corpus, std::uint64_t seed, long i);
const Variant& variant_of(std::uint64_t seed, long i);

/// Tries inputs first … first + inputs - 1 in child processes, so that a crash, an endless loop or
/// a sanitizer's report is a finding of one input and the others are tried all the same.
Campaign run(const Options& options);

/// Tries one text with every formulation, likewise; the findings of it.
Campaign replay(const std::string& text, const std::filesystem::path& folder);

/// For people.
std::string report(const Campaign& campaign);

}  // namespace desmo::fuzz
