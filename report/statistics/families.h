// How the figure tells formulations apart: by what they cut the unknowns into and how they solve.
#pragma once

#include <string>

#include "report/read/configuration.h"

namespace desmo::report {

/// "groups, sparse": of <partition>_<equations>_<algebra>; "interpolated", whatever it is, where
/// not every instant is solved.
std::string family_of(const Configuration& configuration);

}  // namespace desmo::report
