// A synthetic record of bench/check: three candidates of the two trees compared, `base` and `head`.
#pragma once

#include <string>

#include "report/check/check_record.h"
#include "tests/report/sample.h"

namespace desmo::report {

inline constexpr const char* watched = "truck_suspension/114/group_symbolic_klu";

/// Returns a check of 25 rounds: times of both trees differ by a few tenths of a percent.
Json check_sample();

/// Returns the same check with head alone, as a baseline is stored.
Json one_tree_sample();

/// Multiplies head's times of a candidate in the first pass by a factor.
void slow_down(Json& check, const std::string& candidate, double factor);

/// Adds a second pass of a candidate in which head takes `factor` times base's time.
void confirm(Json& check, const std::string& candidate, double factor);

/// Marks head's candidate as failed verification, as desmo_check records it.
void fail_head(Json& check, const std::string& candidate);

/// Marks a candidate as missing on a side ("base" or "head"), as desmo_check records it.
void leave_out(Json& check, const std::string& side, const std::string& candidate);

/// Removes all times and keeps the instruction counts, as desmo_check records it.
void take_no_times(Json& check);

CheckRecord check_from(const Json& json);

}  // namespace desmo::report
