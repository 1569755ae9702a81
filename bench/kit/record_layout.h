#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace desmo::suite {

/// The text of a record: its head indented, and of each list an element a line, as a person may
/// want to read the one and not the other. head: an object with something in it; lists: an object
/// of arrays.
std::string record_layout(const nlohmann::ordered_json& head, const nlohmann::ordered_json& lists);

/// A time above zero to five digits: there are many of them, and what a machine repeats is less.
double rounded(double seconds);

}  // namespace desmo::suite
