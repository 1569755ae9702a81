// Choosing among the points of a record's accuracy experiment, and their times.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "report/read/record.h"
#include "report/statistics/statistics.h"

namespace desmo::report {

/// A point with its key, as Record::points has it.
using NamedPoint = std::pair<const PointKey, Point>;
using Points = std::vector<const NamedPoint*>;

/// Limits of the largest relative position error within which the fastest formulation is sought, ≤.
inline constexpr std::array accuracies{1e-3, 1e-6, 1e-9, 1e-12};

/// Returns one motion of each case: of those with the record's own step and the largest size, the
/// one with the most instants. Leaves out cases without a motion of that step.
std::vector<SeriesKey> drawn_series(const Record& record);

Points points_of(const Record& record, const SeriesKey& series);

/// Returns the points that interpolate no instant between solved ones.
Points solving_every_instant(Points points);

/// Returns the paper's guess, then the other guesses of some points, each once.
std::vector<std::string> guesses_of(const Points& points);

inline bool is_solved(const NamedPoint& point) { return point.second.status == Status::ok; }
/// Returns the largest relative position error of a solved point.
inline double position_error(const NamedPoint& point) { return *point.second.error.position; }
/// Returns the least sample [s] of a step of a solved point.
inline double step_seconds(const NamedPoint& point) {
  return std::ranges::min(point.second.time.seconds);
}

/// Returns the fastest of the solved points with position error ≤ max_error whose configuration
/// fulfils `may`; null when there is none.
const NamedPoint* cheapest(
    const Points& points, double max_error,
    const std::function<bool(const Configuration&)>& may = [](const auto&) { return true; });

/// Returns the fastest point of a formulation with position error ≤ max_error, of those that differ
/// from the paper's settings at most in where steps stop; null when there is none.
const NamedPoint* cheapest_of_paper(const Points& points, std::string_view formulation,
                                    double max_error);

}  // namespace desmo::report
