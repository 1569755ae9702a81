#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tests/fuzz/random.h"
#include "tests/fuzz/tree.h"

namespace desmo::fuzz {

/// A mutation: changes a document in one place or in a few related ones. It leaves the document
/// unchanged, or throws NothingToPick, when it does not apply.
using TextMutation = void (*)(std::string& text, Random& random);
using TreeMutation = void (*)(Tree& root, Random& random);

/// Returns mutations of bytes and tokens, regardless of their meaning.
std::span<const TextMutation> text_mutations();
/// Returns mutations of any JSON: members, elements, values.
std::span<const TreeMutation> json_mutations();
/// Returns mutations of bodies, joints, coordinates and drivers; most results are valid files.
std::span<const TreeMutation> mechanism_mutations();
/// Returns mutations of nominal positions and directions towards degenerate geometry.
std::span<const TreeMutation> geometry_mutations();
/// Returns mutations of motions, times and requests.
std::span<const TreeMutation> scene_mutations();

/// Gives a constant motion to each driver of a scene that has none, and removes motions of other
/// coordinates. Otherwise every scene with changed drivers would be refused.
void give_motion_to_drivers(Tree& root);

/// Returns the spelling of an extreme or invalid number.
std::string_view extreme_number(Random& random);

/// Returns the mechanism of a document: the document itself, or a scene's member. Null when
/// missing.
Tree* mechanism_in(Tree& root);

/// Returns the keys of a member's members: {"A", "B"} for "points". Empty when there are none.
std::vector<std::string> names_under(const Tree& mechanism, std::string_view member);

}  // namespace desmo::fuzz
