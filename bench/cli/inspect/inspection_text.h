#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace desmo::cli {

/// Returns the text of `desmo inspect` for the structure that `desmo inspect --json` writes.
std::string inspection_text(const nlohmann::ordered_json& structure);

}  // namespace desmo::cli
