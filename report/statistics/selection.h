// Choosing among the points of a record, and their times.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "report/read/record.h"
#include "report/statistics/statistics.h"

namespace desmo::report {

/// A point with its name: it refers to the record.
using NamedPoint = std::pair<const PointKey, Point>;
using Points = std::vector<const NamedPoint*>;

/// Errors that answers are wanted within: relative, of position, the largest.
inline constexpr std::array accuracies{1e-3, 1e-6, 1e-9, 1e-12};

/// Returns of each case the motion that is known best: the one with most instants, at the case's
/// largest size and the record's own step. Leaves out cases that have none at that step.
std::vector<SeriesKey> drawn_series(const Record& record);

Points points_of(const Record& record, const SeriesKey& series);

/// Returns the points that interpolate no instant between solved ones.
Points solving_every_instant(Points points);

/// Guesses, each once: the paper's first.
std::vector<std::string> guesses_of(const Points& points);

bool is_solved(const NamedPoint& point);
double position_error(const NamedPoint& point);  ///< the largest; of a solved point
double step_seconds(const NamedPoint& point);    ///< the least sample; of a solved point

/// Returns the ratio of the least samples of a step, of solved points.
SpeedUp speed_up(const NamedPoint& reference, const NamedPoint& variant);

/// The fastest of the solved points within an error, of those that `may`; null when there is none.
const NamedPoint* cheapest(
    const Points& points, double max_error,
    const std::function<bool(const Configuration&)>& may = [](const auto&) { return true; });

/// Returns the fastest of a formulation within an error of positions that has the paper's guess and
/// updates of the Jacobian, at any tolerance; null when there is none.
const NamedPoint* cheapest_of_paper(const Points& points, std::string_view formulation,
                                    double max_error);

}  // namespace desmo::report
