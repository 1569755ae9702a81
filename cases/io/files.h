#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "cases/io/input_error.h"
#include "cases/mechanism/mechanism.h"
#include "cases/mechanism/scene.h"

namespace desmo {

// The functions below read and write the files that cases/files.md specifies. Values are converted
// to metres (or the mechanism's free unit) and radians. Functions that read throw InputError for a
// fault in a file. file_name: the name of the text in messages.

/// Return a mechanism that has passed validate(). Table files are read relative to the folder of
/// the mechanism's file.
Mechanism parse_mechanism(std::string_view text, const std::string& file_name);
Mechanism read_mechanism(const std::filesystem::path& file);

/// Return a scene. Files that it names are read relative to `folder`, or to the folder of its file.
///
///   const Scene scene = read_scene("crank.scene.json");
///   std::puts(write_mechanism(scene.mechanism).c_str());
Scene parse_scene(std::string_view text, const std::string& file_name,
                  const std::filesystem::path& folder);
Scene read_scene(const std::filesystem::path& file);

/// Returns the scene of a library mechanism: library_scene("slider_crank"). Throws
/// std::invalid_argument, with the nearest names, when there is none of that name.
Scene library_scene(std::string_view name);

/// Returns the text of a mechanism file that describes the same mechanism, in metres (or the free
/// unit) and radians. Remainders are lost: each number is written as one double.
std::string write_mechanism(const Mechanism& mechanism);

}  // namespace desmo
