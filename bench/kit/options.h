#pragma once

#include <string_view>

namespace desmo::bench {

/// Reads a whole number. Throws std::invalid_argument, naming the text, unless it is one from min
/// to max.
int whole_number(std::string_view text, int min, int max);

}  // namespace desmo::bench
