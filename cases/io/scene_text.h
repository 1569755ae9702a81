// What is changed in the text of a scene file, the rest of which stays as it was written.
#pragma once

#include <string>
#include <string_view>

namespace desmo {

/// The text of a scene whose member "formulation" is this id, in place of the one it has or behind
/// its other members. text: JSON that parse_scene accepts. id: without characters that JSON
/// escapes.
std::string with_formulation(std::string_view text, std::string_view id);

}  // namespace desmo
