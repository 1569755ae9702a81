#pragma once

#include <string_view>

namespace desmo::bench {

/// Exit code of a program whose command line is wrong (EX_USAGE of sysexits.h).
inline constexpr int usage_error = 64;

/// Reads a whole number. Throws std::invalid_argument, naming the text, unless it is one from min
/// to max.
int whole_number(std::string_view text, int min, int max);

}  // namespace desmo::bench
