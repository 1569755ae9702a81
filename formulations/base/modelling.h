#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace desmo {

/// Coordinates in which a mechanism is modelled. Every model has the points, vectors and relative
/// coordinates of the mechanism under the same names.
enum class Modelling {
  natural,    ///< exactly these: the paper's natural and mixed coordinates
  basis,      ///< the same; those that are linear in the basis of a body are derived from it
  reference,  ///< position and orientation of each body, from which all else is derived
  relative,   ///< joint variables of a spanning tree, from which all else is derived
};

inline constexpr std::array modelling_kinds{Modelling::natural, Modelling::basis,
                                            Modelling::reference, Modelling::relative};
/// Names in ids and on command lines, in the order of modelling_kinds.
inline constexpr std::array<std::string_view, 4> modelling_names{"natural", "basis", "reference",
                                                                 "relative"};

constexpr std::string_view name_of(Modelling modelling) {
  return modelling_names[static_cast<std::size_t>(modelling)];
}

/// Returns whether bodies have frames, from which their points and vectors are derived.
constexpr bool has_frames(Modelling modelling) {
  return modelling == Modelling::reference || modelling == Modelling::relative;
}

}  // namespace desmo
