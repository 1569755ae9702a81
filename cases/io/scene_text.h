// Edits of a scene file's text that leave the rest unchanged.
#pragma once

#include <string>
#include <string_view>

namespace desmo {

/// Returns the text of a scene with the member "formulation" set to this id. The member keeps its
/// position; a new one is added after the other members.
/// - text: JSON that parse_scene() accepts
/// - id: without characters that JSON escapes
std::string with_formulation(std::string_view text, std::string_view id);

}  // namespace desmo
