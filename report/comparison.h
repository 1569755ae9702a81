// One run beside another.
#pragma once

#include "report/read/record.h"
#include "report/text/document.h"

namespace desmo::report {

/// Says how many times as fast the second record is, for everything timed or to be timed in either.
/// The records are comparable (report/comparability.h).
Document make_comparison(const Record& first, const Record& second);

/// Shows the speed-ups of two machines side by side, and no seconds: of everything that both have
/// timed, over the usual reference, each in its own record. The records agree in what was solved.
Document make_comparison_of_machines(const Record& first, const Record& second);

}  // namespace desmo::report
