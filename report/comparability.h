// Which records may be compared: the comparability key.
#pragma once

#include <string>
#include <vector>

#include "report/record.h"

namespace desmo::report {

/// Something that must be the same and is not.
struct Difference {
  std::string what;           ///< "CPU model", "model of four_bar/114", ...
  std::string first, second;  ///< what each record says, or "not recorded"
};

/// Why times of the two records cannot be compared; empty when they can. They must agree in the
/// schema's major version, CPU model, compiler, flags, linking, BLAS core and threads, settings of
/// the analysis, and, for what both have timed, in the model solved and the results found. What
/// either does not record, as those before 1.3.0, counts as different.
std::vector<Difference> why_incomparable(const Record& first, const Record& second);

/// Why times of the two records cannot stand on one page, one beside the other; empty when they
/// can: as above, but for the motions and what was timed. Only one of them may have cells, only one
/// points, and likewise promises, sizes and instructions.
std::vector<Difference> why_apart(const Record& first, const Record& second);

/// "CPU model: A here, B there", a line for each.
std::string describe(const std::vector<Difference>& differences);

}  // namespace desmo::report
