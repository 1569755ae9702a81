#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "bench/kit/time/clock.h"
#include "bench/kit/time/timing_windows.h"

namespace desmo::bench {

/// Returns the name of a clock in a record: "cpu" or "wall".
const char* clock_name(Clock clock);

/// Returns samples of a time as a record holds them: with the clock that they are of.
nlohmann::ordered_json time_json(const std::vector<double>& seconds, Clock clock = Clock::cpu);

/// Returns the timing windows of a time: of every analysis, and the work in each; their least alone
/// where nobody counts the work.
nlohmann::ordered_json windows_json(const TimingWindows& windows);

}  // namespace desmo::bench
