#pragma once

namespace desmo {

/// Extent to which a run is checked.
enum class CheckMode {
  none,       ///< nothing: numbers are what the formulation makes of them
  sample,     ///< one path over N instants, each instant inside it; every N-th with radii
  proof,      ///< every instant and every step of what is requested
  mechanism,  ///< the same, and the positions of all else
};

}  // namespace desmo
