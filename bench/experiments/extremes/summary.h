#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "bench/experiments/extremes/table.h"

namespace desmo::extremes {

std::size_t count(const std::vector<Result>& results, Verdict verdict);

/// A row for people: a line with the number of each verdict, and one for each case and reason that
/// it is not as expected, with the formulations concerned counted and the first named.
std::string summary(const Extreme& row, const std::vector<Result>& results);

}  // namespace desmo::extremes
