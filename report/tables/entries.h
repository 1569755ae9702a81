// Numbers and measurements as places of a table.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "report/statistics/measurements.h"
#include "report/statistics/statistics.h"
#include "report/text/document.h"

namespace desmo::report {

/// Returns what inconclusive_mark, "one run" and "two runs" mean, for the notes of a table.
std::string inconclusive_note();

/// Adds a reservation about what the entry shows.
void add_note(Entry& entry, const std::string& note);

/// "0.4210 ±0.0020", quantities {seconds, half_range, repetitions}; "0.4210 (two runs)" where they
/// are too few for an interval; or the mark.
Entry seconds_entry(const Measured& measured);

/// "0.1122 (median 0.1185)", quantities {seconds, median, repetitions}, likewise; without the
/// median where that is the time.
Entry median_entry(const Measured& measured);

/// Writes so many significant digits, or the mark of what is missing.
Entry number_entry(const std::optional<double>& value, int significant);

/// A number of things, in full.
Entry count_entry(std::size_t count);

/// "1.24 [1.21, 1.27] (19.4 %)", quantities {speed_up, low, high, percent}, with inconclusive_mark
/// where the interval is too wide; "0.17 [0.16, 0.17]", without percentage, of what is slower; or
/// the mark.
Entry speed_up_entry(const MeasuredSpeedUp& measured);

/// The same without the improvement: "1.24 [1.21, 1.27]".
Entry without_percent(Entry entry);

/// "1.24 [1.21, 1.27]", quantities {ratio, low, high}, likewise.
Entry ratio_entry(const SpeedUp& ratio);

/// The mean over the paper's sizes, likewise; "incomplete 4/5" when some have none.
Entry mean_speed_up_entry(const Record& record, std::string_view family, std::size_t variant);

/// The paper's value and whether our interval contains it, both as printed: inside_mark or
/// outside_mark. Of both entries the first quantity is the value, of ours the second and third are
/// the interval. As it is where one of them is missing or ours is of fewer sizes.
Entry compared(Entry published, const Entry& ours);

}  // namespace desmo::report
