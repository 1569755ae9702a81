// Drawing by the dot program of Graphviz.
#pragma once

#include <string>

#include "bench/cli/output.h"

namespace desmo::cli {

/// Draws a graph in the DOT language as SVG to `output`, which the caller finishes. Throws Error
/// (unavailable) when there is no dot program, or when it fails.
void draw_svg(const std::string& graph, Output& output);

}  // namespace desmo::cli
