#pragma once

#include <string>
#include <vector>

namespace desmo::accuracy {

/// Prints whether the error grows in a long run: errors of the first and the last 1000 of its
/// steps, relative to the mechanism's scales, against the quadruple reference. The step is the
/// scene's; the motion goes on beyond the scene's end. words: MECHANISM ID [STEPS [TOLERANCE]],
/// where MECHANISM is <case>/<coordinates> or a mechanism of the library. Returns whether the run
/// reached its end. Throws std::invalid_argument, naming the word, for an unusable one.
bool print_drift(const std::vector<std::string>& words);

}  // namespace desmo::accuracy
