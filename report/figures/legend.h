// What the legend of a figure lists, and what the reader of the page chooses from.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <vector>

namespace desmo::report {

/// Leaves in a specification's parameter `shown` and in the scales of colour and shape (of these
/// encodings, which have either) only what was measured: it keeps its colour and shape. What the
/// design does not know is a grey cross.
void keep_measured(nlohmann::ordered_json& spec,
                   const std::vector<nlohmann::ordered_json*>& encodings,
                   const std::set<std::string>& measured);

}  // namespace desmo::report
