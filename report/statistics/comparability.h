// The conditions under which records may be compared.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "report/statistics/measurements.h"

namespace desmo::report {

/// A quantity that must be the same in two records and is not.
struct Difference {
  std::string what;           ///< "CPU model", "model of four_bar/114", ...
  std::string first, second;  ///< the value in each record, or "not recorded"
};

/// Returns why times of the two records cannot be compared; empty when they can. They must agree in
/// - the environment: CPU model, compiler, build type, flags, linking, BLAS core and threads
/// - settings: tolerance, iterations at most, first guess, step and duration
/// - the model and the results of what both have timed
/// At least one measurement must be in both. A value that only one of the records has counts as a
/// difference. So does linking where neither has it.
std::vector<Difference> incomparable_reasons(const Record& first, const Record& second);

/// Returns why speed-ups of two machines cannot stand side by side; empty when they can. They must
/// agree in all that incomparable_reasons() compares, except for the environment.
std::vector<Difference> different_work_reasons(const Record& first, const Record& second);

/// Times of one experiment by one clock.
struct TimedGroup {
  std::string name;  ///< name of its table
  std::string what;  ///< words for the times, such as "CPU seconds"
  Measurements measurements;
};

/// Returns the key under which a point of the accuracy experiment stands among times: step and
/// number of instants become settings of its id.
CandidateKey timing_key(const PointKey& point);

/// Returns every group that a record may have, in the order of tables, empty groups included.
std::vector<TimedGroup> timed_groups(const Record& record);

/// Returns the key of a key's reference. The speed-up of a key is the reference's time divided by
/// its own. By the CPU clock, the reference is the usual one with the same case, size, request and
/// step; by the wall clock, it is the same analysis or request on one thread.
CandidateKey reference_of(const CandidateKey& key);

}  // namespace desmo::report
