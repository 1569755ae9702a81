// Files that the build puts into the program, so that it needs no path at run time.
#pragma once

#include <string_view>

namespace desmo::report {

/// Returns the text of a file by its name without folder: "texts.txt", "table2_speedup.csv". Throws
/// std::logic_error for a file that report/CMakeLists.txt does not embed.
std::string_view embedded_file(std::string_view name);

}  // namespace desmo::report
