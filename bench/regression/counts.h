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

/// Counts with callgrind, as many at once as there are cores: a fixed number of steps and of
/// iterations, in a fixed environment. callgrind shows every program the same processor, so counts
/// do not depend on the machine's. Throws std::runtime_error, naming the cell and what desmo_steps
/// or valgrind said, when one cannot be counted.
Counts count_instructions(const std::vector<Counted>& all);

/// What else the counts depend on: "valgrind-3.19.0, glibc 2.36"; empty without valgrind.
std::string counting_tool();

}  // namespace desmo::regression
