#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace desmo::regression {

using Json = nlohmann::ordered_json;

/// Reads the results file of a check (results/check.schema.json), to add to it. Throws
/// std::runtime_error, naming the file.
Json load_check(const std::string& path);

/// Writes it so that it appears whole or not at all. Throws std::runtime_error, naming the file.
void save_check(const Json& check, const std::string& path);

}  // namespace desmo::regression
