// Which times of a record stand beside those of another.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "report/read/record.h"
#include "report/statistics/measurements.h"

namespace desmo::report {

/// Times of one experiment by one clock.
struct TimedGroup {
  std::string name;  ///< of its table
  std::string what;  ///< "CPU seconds", "wall-clock seconds of several threads"
  std::map<CandidateKey, Timing> timings;
};

/// Returns every group that a record may have, in the order of tables; empty ones too.
std::vector<TimedGroup> timed_groups(const Record& record);

/// Returns the key that speed-ups of a key are over: the usual reference of the same case and size,
/// with the same request; of several threads, the same analysis on one.
CandidateKey reference_of(const CandidateKey& key);

}  // namespace desmo::report
