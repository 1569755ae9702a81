#pragma once

#include <vector>

namespace desmo::size {

/// Prints how reading, analysing and solving a mechanism file grow with the number of bodies, for
/// generated files of both scalable cases, in CPU seconds; a step is the fastest of a few. Throws
/// std::runtime_error when one cannot be solved.
void print_analysis(const std::vector<int>& bodies);

}  // namespace desmo::size
