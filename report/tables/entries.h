// Numbers and measurements as entries of a table.
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

/// Adds a reservation to an entry, in `shown` and in `note`.
void add_note(Entry& entry, const std::string& note);

/// Returns the entry of a number with so many significant digits; missing_mark for none.
Entry number_entry(const std::optional<double>& value, int significant);

/// Returns "1.00 reference", for the candidate that all others are compared with.
Entry reference_entry();

/// The numbers next to a time: half the range of its samples, the least and largest sample, or the
/// median where that differs in the digits shown.
enum class Spread { half_range, range, median };

/// Writes a ratio without its interval: 1.24; where it has no interval, with one significant digit.
std::string ratio_text(const SpeedUp& ratio);

/// Returns the entry of a time, or its mark.
/// - half_range: "0.4210 ±0.0020", quantities {seconds, half_range, repetitions}
/// - range: "0.1122 (0.1102 – 0.1185)", quantities {seconds, least, largest, repetitions}
/// - median: "0.1122 (median 0.1185)", quantities {seconds, median, repetitions}; where the digits
///   of both are the same, "0.1122" without a median
/// Times of fewer than three repetitions have one significant digit and no spread: "0.4", "10".
Entry seconds_entry(const Measured& measured, Spread spread = Spread::half_range);

/// Returns the entry of the time of an analysis divided by the record's number of instants [µs];
/// missing_mark without a time. It has one digit with fewer than three repetitions.
Entry instant_entry(const Record& record, const Measured& measured, int significant = 4);

/// Adds the entries of the errors of position, velocity and acceleration to a row.
void add_errors(std::vector<Entry>& row, const Measurement& candidate);

/// Returns the entry of a speed-up, "1.24 [1.21, 1.27]", quantities {ratio, low, high}, or its
/// mark. It has inconclusive_mark where the interval is too wide, and one digit and no interval
/// with fewer than three repetitions: "1".
/// - with_percent: "1.24 [1.21, 1.27] (19.4 %)", with one quantity more, which is missing where the
///   variant is slower or there is no interval
Entry ratio_entry(const SpeedUp& ratio, bool with_percent = false);
Entry ratio_entry(const MeasuredSpeedUp& measured, bool with_percent = false);

/// Returns the entry of the least and the second least sample of a step's time [µs]: "12.34 –
/// 12.41", quantities {microseconds, again}. A single sample has one digit.
Entry step_time_entry(const Time& step);

/// Returns the entry of an error, "8.0e-10", quantities {error}; missing_mark for none.
Entry error_entry(const std::optional<double>& error);

// ---- excerpts of tables, for the short report ----

/// Returns an excerpt of a table: its first 14 rows for which `keep` is true, in the columns of
/// `head`. All of these must be columns of the table.
Table excerpt(
    const Table& table, Table head,
    const std::function<bool(const std::vector<Entry>&)>& keep = [](const auto&) { return true; });

/// Tells whether a row is of the case in the table's last row: the truck, where both cases were
/// measured. The first column has the case.
inline bool is_of_last_case(const Table& table, const std::vector<Entry>& row) {
  return row.front().shown == table.rows.back().front().shown;
}

}  // namespace desmo::report
