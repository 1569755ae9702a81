#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "bench/regression/side.h"

namespace desmo::regression {

/// Instructions of each cell's counted steps on each side.
using Counts = std::map<std::string, std::map<std::string, std::int64_t>>;

/// One cell on one side.
struct Counted {
  const Side* side;
  std::string cell;
};

/// Counts a fixed number of steps with a fixed number of iterations (see count_steps). Throws
/// std::runtime_error, naming the cell and what desmo_steps or valgrind said, when one cannot be
/// counted.
Counts count_instructions(const std::vector<Counted>& all);

}  // namespace desmo::regression
