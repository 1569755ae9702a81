#pragma once

#include <string>
#include <vector>

#include "bench/experiments/accuracy/search.h"

namespace desmo::accuracy {

/// A configuration, measured apart from any search.
struct Rival {
  std::string id;
  double error = 0;             ///< relative position error, the largest
  std::vector<double> seconds;  ///< samples of a step
};

/// What a search promised, and what that is worth.
struct Promise {
  double allowed = 0;   ///< relative position error that was asked for
  double promised = 0;  ///< that the search says its choice has
  Rival choice;
  Rival best;  ///< the fastest of everything there is that a search may promise; perhaps the choice
};

/// Everything there is on the begin of a motion: every formulation with all settings.
std::vector<Tried> everything(const TunedMotion& motion);

/// Searches as `desmo tune` does, and measures its choice in turn with what was as fast on the
/// begin of the motion, over the whole of it. `control` is the whole motion, compared at every
/// instant; all is what everything() gave. Throws std::runtime_error when nothing holds the error.
Promise promise(const TunedMotion& motion, const Problem& control, const std::vector<Tried>& all,
                double allowed, const Effort& effort = {});

}  // namespace desmo::accuracy
