#pragma once

#include <string>
#include <vector>

namespace desmo::regression {

/// Returns the names of the candidates that bench/check measures: every partition, evaluation and
/// algebra of the table of variants at least once, each at a size that takes about a millisecond.
/// Leaves out algebras that exist on some machines only. Leaves out the four-bar's groups of two
/// unknowns with LAPACK or Eigen: their time is mostly that of calls, which changes by 5 % with the
/// alignment of code alone.
std::vector<std::string> measured_candidates();

/// Returns a record as results/record.schema.json defines it, without samples, of candidates
/// verified against the quadruple reference over their first instants, 10 ms apart. Candidates that
/// this build does not have are "not_run".
std::string verified_record(int instants, const std::vector<std::string>& names);

}  // namespace desmo::regression
