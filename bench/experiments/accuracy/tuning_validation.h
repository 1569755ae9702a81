#pragma once

#include <string>
#include <vector>

#include "bench/experiments/accuracy/search.h"

namespace desmo::accuracy {

/// A configuration, measured apart from any search.
struct Measured {
  std::string id;
  double error = 0;             ///< relative position error, the largest
  std::vector<double> seconds;  ///< samples of a step
};

/// The promise of a search, and what it is worth.
struct Promise {
  double allowed = 0;   ///< relative position error that was asked for
  double promised = 0;  ///< that the search says its choice has
  Measured choice;
  Measured best;  ///< the fastest of all that a search may promise; perhaps the choice
};

/// Returns everything there is on the begin of a motion: every formulation with all settings.
std::vector<Tried> everything(const TunedMotion& motion);

/// Searches as `desmo tune` does, and measures its choice in turn with what was as fast on the
/// begin of the motion, over the whole of it. Throws std::runtime_error when nothing holds the
/// error.
///
/// control: the whole motion, compared at every instant.
/// all: what everything() gave.
Promise promise(const TunedMotion& motion, const Problem& control, const std::vector<Tried>& all,
                double allowed, const Effort& effort = {});

/// Records what the choices of `desmo tune` are worth: is the error that was asked for held at
/// every instant of the motion, and how much slower is the choice than the best there is?
/// mechanisms: their names; none: all that are tried. Throws std::invalid_argument, naming a
/// mechanism that is not among those.
void validate_tuning(const std::string& record, const std::string& command,
                     const std::vector<std::string>& mechanisms);

}  // namespace desmo::accuracy
