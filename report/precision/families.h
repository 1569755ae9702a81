// How the figure tells formulations apart: by what they cut the unknowns into and how they solve.
#pragma once

#include <string>
#include <string_view>

namespace desmo::report {

/// "groups, sparse": of <partition>_<equations>_<algebra>.
std::string family_of(std::string_view formulation);

}  // namespace desmo::report
