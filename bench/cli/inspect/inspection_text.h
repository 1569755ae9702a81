#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace desmo::cli {

/// Returns what `desmo inspect --json` writes in words and figures.
std::string inspection_text(const nlohmann::ordered_json& structure);

}  // namespace desmo::cli
