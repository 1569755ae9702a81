#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tests/fuzz/random.h"
#include "tests/fuzz/tree.h"

namespace desmo::fuzz {

/// Changes a document in one place or a few related ones; leaves it as it is where there is nothing
/// to be changed in its way. Each is one row of a table.
using TextMutation = void (*)(std::string& text, Random& random);
using TreeMutation = void (*)(Tree& root, Random& random);

/// Of bytes and tokens, whatever they mean.
std::span<const TextMutation> text_mutations();
/// Of any JSON: members, elements, values.
std::span<const TreeMutation> json_mutations();
/// Of bodies, joints, coordinates and drivers, such that most results are mechanism files.
std::span<const TreeMutation> mechanism_mutations();
/// Of nominal positions and directions, towards those where geometry degenerates.
std::span<const TreeMutation> geometry_mutations();
/// Of motions, times and requests.
std::span<const TreeMutation> scene_mutations();

/// A constant motion for each driver of a scene that has none; none for what is not driven. Without
/// it, scenes whose drivers were changed would all be refused.
void give_motion_to_drivers(Tree& root);

/// A number as a file would never have it, or seldom.
std::string_view extreme_number(Random& random);

/// The mechanism of a document: itself, or that within a scene. Null when it is not there.
Tree* mechanism_in(Tree& root);

/// Keys of a member's members: {"A", "B"} of "points". Empty when there are none.
std::vector<std::string> names_under(const Tree& mechanism, std::string_view member);

}  // namespace desmo::fuzz
