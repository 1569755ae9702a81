#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace desmo::report {

/// What a record knows of the equal segments into which a motion is cut; each vector has one value
/// a segment, or is empty where the record has none.
struct Segments {
  std::vector<double> least;     ///< CPU seconds: the least that any analysis took; since 1.4.0
  std::vector<double> instants;  ///< in it; since 1.6.0, as what follows
  std::vector<double> updates;   ///< by Newton's method
  std::vector<std::vector<double>> samples;  ///< CPU seconds, by analysis
};

/// The CPU seconds of an analysis that nothing disturbed, from all there were or from all but one.
///
/// A segment takes so much for each instant and so much for each update, and at times more, never
/// less: of the points (updates an instant, seconds an instant) of all segments and analyses, the
/// undisturbed ones lie on a line, which rises, but not faster than in proportion, and the others
/// above it. So the time is that of the lower convex envelope of these points at the updates of the
/// whole motion, or less where that is more than a single point allows.
///
/// segments: with samples, two or more where one is left out.
double undisturbed(const Segments& segments, std::optional<std::size_t> left_out = std::nullopt);

/// The largest that leaving out one analysis makes of it: with the best of them gone, what the
/// others say. segments: with two samples or more.
double undisturbed_without_best(const Segments& segments);

}  // namespace desmo::report
