#pragma once

namespace desmo {

/// Extent to which a run is checked.
enum class CheckMode {
  none,       ///< nothing: numbers are what the formulation makes of them. Short steps lead it from
              ///< the drawing to a start away from it, also in its later runs
  sample,     ///< every N-th instant, with radii, and one path from each to the next, which the
              ///< instants between lie in
  proof,      ///< every instant and every step of what is requested
  mechanism,  ///< like proof, and the positions of all that is not requested
};

}  // namespace desmo
