#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include "cases/mechanism/mechanism.h"
#include "cases/mechanism/scene.h"

namespace desmo {

/// Error in an input. The message is "<file>: <place>: <what is wrong>; <remedy>". The place is a
/// line and a column if the text is not JSON, else a JSON pointer such as /joints/2/points/0, or
/// "top level". It is missing when the file cannot be read. Names from the input are shortened, and
/// escaped for terminals.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The functions below read and write the files that cases/files.md specifies. Values are converted
/// to metres (or the mechanism's free unit) and radians. All throw InputError. file_name is used in
/// messages.

/// Return a mechanism that has passed validate().
Mechanism parse_mechanism(std::string_view text, const std::string& file_name);
Mechanism read_mechanism(const std::filesystem::path& file);

/// Return a scene. A mechanism file that it names is read relative to `folder`.
///
///   const Scene scene = read_scene("crank.scene.json");
///   std::puts(write_mechanism(scene.mechanism).c_str());
Scene parse_scene(std::string_view text, const std::string& file_name,
                  const std::filesystem::path& folder);
Scene read_scene(const std::filesystem::path& file);

/// Returns the scene of a library mechanism: library_scene("slider_crank"). Throws
/// std::invalid_argument, with the nearest names, when there is none of that name.
Scene library_scene(std::string_view name);

/// Returns the text of a mechanism file that describes the same mechanism.
std::string write_mechanism(const Mechanism& mechanism);

}  // namespace desmo
