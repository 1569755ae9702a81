#pragma once

#include <string>
#include <string_view>

namespace desmo {

/// Returns a JSON text with blanks in place of its comments, so that everything else keeps its
/// place. Comments are `// …` to the end of the line, and `/* … */`. Line ends within comments
/// stay, and so does a `/*` without `*/`.
std::string without_comments(std::string_view text);

}  // namespace desmo
