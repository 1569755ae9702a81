#pragma once

namespace desmo {

/// Extent to which a run is checked.
enum class CheckMode {
  none,       ///< nothing: numbers are delivered as the formulation makes them. Short steps lead it
              ///< from the drawing to a start away from it, also in later runs of the formulation
  sample,     ///< every N-th instant and the last one, with radii. A path is proven between two of
              ///< them. Instants between them lie in it, or are checked one by one
  proof,      ///< every instant and every step of what is requested
  mechanism,  ///< for run_checked() the same as `proof`. Callers then plan with
              ///< PlanExtent::mechanism: the positions of all else are in the model, too
};

}  // namespace desmo
