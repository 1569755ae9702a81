// Numbers and measurements as places of a table, with what tables are written with.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "report/statistics/measurements.h"
#include "report/statistics/selection.h"
#include "report/statistics/statistics.h"
#include "report/text/digits.h"
#include "report/text/document.h"
#include "report/text/texts.h"

namespace desmo::report {

/// Adds a reservation about what the entry shows.
void add_note(Entry& entry, const std::string& note);

/// Writes a number with significant digits, or the mark of what is missing.
Entry number_entry(const std::optional<double>& value, int significant);

/// Returns "1.00 reference", for the candidate that all others are compared with.
Entry reference_entry();

/// The number next to a time: half the range of its samples, their range, or their median where
/// that is another time.
enum class Spread { half_range, range, median };

/// Writes a ratio, without interval: 1.24; of fewer than three repetitions one digit.
std::string ratio_text(const SpeedUp& ratio);

/// "0.4210 ±0.0020", quantities {seconds, half_range, repetitions}; "0.1122 (0.1102 – 0.1185)",
/// {seconds, least, largest, repetitions}; "0.1122 (median 0.1185)", {seconds, median,
/// repetitions}; "0.4" of fewer than three repetitions, an order of magnitude; or the mark.
Entry seconds_entry(const Measured& measured, Spread spread = Spread::half_range);

/// Microseconds of an instant, of a whole analysis of the record's motion.
Entry instant_entry(const Record& record, const Measured& measured, int significant = 4);

/// Adds the errors of position, velocity and acceleration to a row.
void add_errors(std::vector<Entry>& row, const Measurement& candidate);

/// "1.24 [1.21, 1.27]", quantities {ratio, low, high}, with inconclusive_mark where the interval is
/// too wide; "1" of fewer than three repetitions; or the mark. with_percent: "1.24 [1.21, 1.27]
/// (19.4 %)", and a quantity more; without the percentage for what is slower.
Entry ratio_entry(const SpeedUp& ratio, bool with_percent = false);
Entry ratio_entry(const MeasuredSpeedUp& measured, bool with_percent = false);

/// Returns the time of a step [µs], measured twice: "12.34 – 12.41", quantities {microseconds,
/// again}.
Entry step_time_entry(const std::vector<double>& samples);

/// "8.0e-10", quantities {error}; of nothing the mark.
Entry error_entry(const std::optional<double>& error);

// ---- the few rows of a table that stand in front of an experiment ----

/// Returns an excerpt of a table: its first 14 rows for which `keep` is true, in the columns of
/// `head`, which a block of the texts defines.
Table excerpt(
    const Table& table, Table head,
    const std::function<bool(const std::vector<Entry>&)>& keep = [](const auto&) { return true; });

/// Tells whether a row is of the case that stands last: the truck, where both cases were measured.
inline bool is_of_last_case(const Table& table, const std::vector<Entry>& row) {
  return row.front().shown == table.rows.back().front().shown;
}

}  // namespace desmo::report
