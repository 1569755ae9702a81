// The conditions under which records may be compared.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "report/statistics/measurements.h"

namespace desmo::report {

/// Something that must be the same and is not.
struct Difference {
  std::string what;           ///< "CPU model", "model of four_bar/114", ...
  std::string first, second;  ///< the value in each record, or "not recorded"
};

/// Says why times of the two records cannot be compared; empty when they can. They must agree in
/// CPU model, compiler, build type, flags, linking, BLAS core and threads, settings, and, for what
/// both have timed, in the model and the results. At least one measurement must be in both. What
/// only one records counts as different, and linking also where neither does.
std::vector<Difference> incomparable_reasons(const Record& first, const Record& second);

/// Says why speed-ups of two machines cannot stand side by side; empty when they can. They must
/// agree in everything that incomparable_reasons() compares, but for the environment.
std::vector<Difference> different_work_reasons(const Record& first, const Record& second);

/// Times of one experiment by one clock.
struct TimedGroup {
  std::string name;  ///< of its table
  std::string what;  ///< "CPU seconds", "wall-clock seconds of several threads"
  Measurements measurements;
};

/// Returns the key of a point of accuracy among times: the motion is a part of its id.
CandidateKey timing_key(const PointKey& point);

/// Returns every group that a record may have, in the order of tables; empty ones too.
std::vector<TimedGroup> timed_groups(const Record& record);

/// Returns the key that speed-ups of a key are over: the usual reference of the same case and size,
/// with the same request; of several threads, the same analysis on one.
CandidateKey reference_of(const CandidateKey& key);

}  // namespace desmo::report
