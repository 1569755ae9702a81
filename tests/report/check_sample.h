// A made-up check of three candidates, and what can happen to it.
#pragma once

#include <string>

#include "report/check/check_record.h"
#include "tests/report/sample.h"

namespace desmo::report {

inline constexpr const char* watched = "truck_suspension/114/group_symbolic_klu";

/// 25 rounds of both sides, which differ by a few tenths of a percent either way; work counted.
Json check_sample();

/// The same of one tree, as a baseline has it.
Json one_tree_sample();

/// Multiplies head's times of a candidate, in the first pass.
void slow_down(Json& check, const std::string& candidate, double factor);

/// Adds a second pass of a candidate in which head takes so many times base's time.
void confirm(Json& check, const std::string& candidate, double factor);

/// Makes head's answers wrong, as desmo_check records it.
void fail_head(Json& check, const std::string& candidate);

/// Makes a candidate one that a side does not have, as desmo_check records it.
void leave_out(Json& check, const std::string& side, const std::string& candidate);

/// Makes it a check of Work alone, as desmo_check records it.
void take_no_times(Json& check);

CheckRecord check_from(const Json& json);

}  // namespace desmo::report
