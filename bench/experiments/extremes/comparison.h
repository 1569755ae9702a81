#pragma once

#include <cstddef>

#include "bench/experiments/extremes/problem.h"
#include "formulations/formulation.h"

namespace desmo::extremes {

/// How wrong an instant is that a formulation found, in those of the problem's answers, at that of
/// the compared instants; an answer is known. Whole turns of angles count for nothing where an
/// estimate alone says which is meant.
PerLevel<double> error_of(const Instant& instant, const Problem& problem, std::size_t answers,
                          std::size_t next);

}  // namespace desmo::extremes
