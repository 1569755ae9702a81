#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace desmo {

/// Coordinates in which a mechanism is modelled. Every model has the points, vectors and relative
/// coordinates of the mechanism under the same names. A derived coordinate follows from others by
/// an explicit equation.
enum class Modelling {
  natural,    ///< no others, none derived: the paper's natural and mixed coordinates
  basis,      ///< no others; points and vectors that are linear in a body's basis are derived
  reference,  ///< also position and orientation of each body, from which points and vectors follow
  relative,   ///< also joint variables of a spanning tree, from which points and vectors follow
};

inline constexpr std::array modelling_kinds{Modelling::natural, Modelling::basis,
                                            Modelling::reference, Modelling::relative};
/// Names in ids and on command lines, in the order of modelling_kinds.
inline constexpr std::array<std::string_view, 4> modelling_names{"natural", "basis", "reference",
                                                                 "relative"};

/// Returns the name of a modelling in ids and on command lines.
constexpr std::string_view name_of(Modelling modelling) {
  return modelling_names[static_cast<std::size_t>(modelling)];
}

/// Returns whether each body has a frame (origin and axes), from which its points and vectors are
/// derived.
constexpr bool has_frames(Modelling modelling) {
  return modelling == Modelling::reference || modelling == Modelling::relative;
}

}  // namespace desmo
