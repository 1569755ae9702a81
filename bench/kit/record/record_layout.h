#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace desmo::bench {

/// Returns the text of a record: its head indented, and an element of a list on each line, as a
/// person may want to read the one and not the other.
///
/// head: an object with something in it.
/// sections: an object of objects of arrays.
std::string record_layout(const nlohmann::ordered_json& head,
                          const nlohmann::ordered_json& sections);

/// A time above zero to five digits: there are many of them, and what a machine repeats is less.
double rounded(double seconds);

}  // namespace desmo::bench
