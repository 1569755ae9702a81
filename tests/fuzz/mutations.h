#pragma once

#include <string>

#include "tests/fuzz/grammar.h"
#include "tests/random.h"

namespace desmo::fuzz {

// Mutations that no grammar can say. They throw NothingToPick where they do not apply.

/// Moves nominal positions and directions, most of them towards degenerate geometry.
void move_geometry(Json& root, Random& random);

/// Removes a body and its joints, so that a mechanism remains.
void remove_body(Json& root, Random& random);

/// Repeats a member under the same key.
void repeat_member(Json& root, Random& random);

/// Gives a constant motion to each driver of a scene that has none, and removes motions of other
/// coordinates. Otherwise every scene with changed drivers would be refused.
void give_motion_to_drivers(Json& root);

/// Replaces some bytes, a token or a line, regardless of their meaning.
void spoil_text(std::string& text, const Grammar& grammar, Random& random);

}  // namespace desmo::fuzz
