#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/kit/candidate_name.h"

namespace desmo::instructions {

/// Instructions of a step of one formulation. Its id has one of bench::check_suffixes where the run
/// is checked.
struct StepCount : bench::CandidateName {
  std::int64_t instructions = 0;  ///< per step, with as many Newton iterations as it takes
  std::int64_t checks = 0;        ///< part of `instructions` that checks take
  int steps = 0;                  ///< number of counted steps
};

/// Returns what is to be counted of both cases:
/// - all formulations except blocks, dense global solves and slow libraries (slow_reason)
/// - paper::extended_ids that callgrind can count
/// - bench::checked_ids, in checked runs
///
/// coordinates: 0 means the largest of the paper's sizes. Throws std::invalid_argument, which names
/// the sizes, where a case has no such size.
std::vector<StepCount> to_be_counted(int coordinates);

/// Counts with the program desmo_steps, as count_steps does. Throws std::runtime_error, naming the
/// formulation, when one cannot be counted.
void count(std::vector<StepCount>& all, const std::string& desmo_steps);

}  // namespace desmo::instructions
