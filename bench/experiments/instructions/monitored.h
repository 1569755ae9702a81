#pragma once

#include <string_view>

namespace desmo::instructions {

/// Ends the id of a formulation whose run is monitored (run_safely): what that costs is part of
/// what is counted.
inline constexpr std::string_view monitored_suffix = "/monitored";

inline bool is_monitored(std::string_view id) { return id.ends_with(monitored_suffix); }

/// Returns the id of the formulation itself.
inline std::string_view formulation_of(std::string_view id) {
  return is_monitored(id) ? id.substr(0, id.size() - monitored_suffix.size()) : id;
}

}  // namespace desmo::instructions
