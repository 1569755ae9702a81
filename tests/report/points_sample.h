// A made-up record of time against error, small enough to work out by hand.
#pragma once

#include <string>

#include "tests/report/sample.h"

namespace desmo::report {

/// The truck at 114 and 225 coordinates and the four-bar at 114, at steps of 10 ms, and the truck's
/// largest size at 1 ms. Every time has three samples: the time, 2 % more and half as much again.
Json points_record();

/// An "ok" point of the truck with 225 coordinates: microseconds of a step and position error.
Json solved_point(const std::string& id, double microseconds, double error,
                  double iterations = 1.03);

/// The point of the truck with 225 coordinates at 10 ms of that id. Fails the test when there is
/// none.
Json& point_of(Json& record, const std::string& id);

}  // namespace desmo::report
