#pragma once

#include <string>
#include <vector>

namespace desmo::accuracy {

/// Records what the choices of `desmo tune` are worth: is the error that was asked for held at
/// every instant of the motion, and how much slower is the choice than the best there is?
/// mechanisms: their names; none: all that are tried. Throws std::invalid_argument, naming a
/// mechanism that is not among those.
void validate_tuning(const std::string& record, const std::string& command,
                     const std::vector<std::string>& mechanisms);

}  // namespace desmo::accuracy
