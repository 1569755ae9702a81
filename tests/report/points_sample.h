// A synthetic record of time against error, small enough to check by hand.
#pragma once

#include <string>

#include "tests/report/sample.h"

namespace desmo::report {

/// Returns the record: the truck at 114 and 225 coordinates and the four-bar at 114, with steps of
/// 10 ms, and the truck's largest size with 1 ms. Every time has three samples: the time, 2 % more
/// and 50 % more.
Json points_record();

/// Returns a point of status "ok" of the truck with 225 coordinates. microseconds: time per step.
/// error: position error.
Json solved_point(const std::string& id, double microseconds, double error,
                  double iterations = 1.03);

/// Returns the point with this id of the truck with 225 coordinates at 10 ms. Fails the test when
/// there is none.
Json& point_of(Json& record, const std::string& id);

}  // namespace desmo::report
