#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "bench/regression/side.h"

namespace desmo::regression {

/// Name of the fixed kernel that is timed like a cell in every round.
inline constexpr const char* control = "control";

/// Of each cell, and of the control, the least CPU seconds on each side, a value a round.
using Times = std::map<std::string, std::map<std::string, std::vector<double>>>;

/// Times cells on all sides, one or two, in so many rounds. In a round every side has a new
/// process, so that no build keeps the luck of its place in memory; all share one core, which
/// changes from round to round. Cells come in random order, and with each cell the sides take turns
/// in random order, each turn with newly placed data. Throws std::runtime_error when a side does
/// not answer.
Times time_rounds(const std::vector<Side>& sides, std::vector<std::string> cells, int rounds,
                  std::uint64_t seed);

}  // namespace desmo::regression
