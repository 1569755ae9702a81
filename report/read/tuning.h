// What the choices of desmo tune are worth, as a record holds it: plain data.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace desmo::report {

/// A configuration, measured apart from any search.
struct TunedChoice {
  std::string id;
  double error = 0;                      ///< relative, of position, the largest
  std::vector<double> seconds_per_step;  ///< samples of CPU time, at least one
};

/// One search, and its control.
struct Promise {
  std::string mechanism;
  std::int64_t coordinates = 0;
  double step_seconds = 0;
  std::int64_t instants = 0;  ///< of the whole motion
  double allowed = 0;         ///< error that was asked for
  double promised = 0;        ///< that the search says its choice has
  std::int64_t compared = 0;  ///< instants of the control
  std::int64_t tried = 0;     ///< configurations that `best` is the best of
  TunedChoice choice, best;
};

}  // namespace desmo::report
