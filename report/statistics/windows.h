#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace desmo::report {

/// Times of the equal timing windows, pieces between two clock readings, into which a motion is
/// cut. Each vector has one value a window, or is empty where the record has none.
struct Windows {
  std::vector<double> least;     ///< seconds: the least that any analysis took
  std::vector<double> instants;  ///< in it; empty, as what follows, where nobody counts updates
  std::vector<double> updates;   ///< by Newton's method
  std::vector<std::vector<double>> samples;  ///< seconds, by analysis
};

/// The seconds of an analysis that nothing disturbed, from all there were or from all but one.
///
/// A window takes so much for each instant and so much for each update, and at times more, never
/// less: of the points (updates an instant, seconds an instant) of all windows and analyses, the
/// undisturbed ones lie on a line, which rises, but not faster than in proportion, and the others
/// above it. So the time is that of the lower convex envelope of these points at the updates of the
/// whole motion, or less where that is more than a single point allows.
///
/// windows: with samples, two or more where one is left out.
double undisturbed(const Windows& windows, std::optional<std::size_t> left_out = std::nullopt);

/// The largest that leaving out one analysis makes of it: with the best of them gone, what the
/// others say. windows: with two samples or more.
double undisturbed_without_best(const Windows& windows);

}  // namespace desmo::report
