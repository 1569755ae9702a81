#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "cases/io/input_error.h"
#include "cases/mechanism/mechanism.h"
#include "cases/mechanism/scene.h"

namespace desmo {

/// Mechanism files and scene files are specified in cases/files.md; values are converted to metres
/// (or the mechanism's free unit) and radians. All throw InputError. `file_name` is for messages.

/// What is returned has passed validate().
Mechanism parse_mechanism(std::string_view text, const std::string& file_name);
Mechanism read_mechanism(const std::filesystem::path& file);

/// A mechanism file that the scene names is sought relative to `folder`.
Scene parse_scene(std::string_view text, const std::string& file_name,
                  const std::filesystem::path& folder);
Scene read_scene(const std::filesystem::path& file);

/// The scene of a library mechanism. Throws std::invalid_argument, with the nearest names, when
/// there is none of that name.
Scene library_scene(std::string_view name);

/// The text of a mechanism file that describes the same mechanism.
std::string write_mechanism(const Mechanism& mechanism);

}  // namespace desmo
