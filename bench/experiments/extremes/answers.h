#pragma once

#include <cstddef>

#include "bench/experiments/extremes/problem.h"

namespace desmo::extremes {

/// For the problem's chain of that index, by the closed form. Where the chain cannot be solved, the
/// problem no longer can.
Answers chain_answers(Problem& problem, std::size_t index);

/// For the whole mechanism, by two formulations in quadruple precision. Throws std::runtime_error
/// where they do not converge or do not agree.
Answers reference_answers(const Problem& problem);

}  // namespace desmo::extremes
