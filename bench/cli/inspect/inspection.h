// The structure of a mechanism as one JSON document, which both output formats are written from.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "bench/cli/input.h"

namespace desmo::cli {

/// Returns the structure of an input and its model; the keys are those of `desmo inspect --json`.
/// Throws InputError.
nlohmann::ordered_json inspect(const Input& input, const ModellingResult& modelled);

/// Returns a structure in words and figures.
std::string inspection_text(const nlohmann::ordered_json& structure);

}  // namespace desmo::cli
