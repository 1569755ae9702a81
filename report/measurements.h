// Finding measurements in a record. Whoever looks for a number gets it or the reason for none.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "report/document.h"
#include "report/record.h"
#include "report/statistics.h"

namespace desmo::report {

/// A measurement, or the mark that stands in its place.
struct Measured {
  std::optional<Summary> seconds;  ///< CPU time of one analysis
  std::string mark;  ///< failed_mark, not_run_mark or missing_mark; empty when measured
};

Measured measured(const Record& record, const CellKey& key);
Measured measured(const Request& request);
Measured measured(const Cell& cell);

/// What a cell, request or peer says of its time.
struct Timing {
  Measured time;
  std::string remark;  ///< why there is no time; empty when there is one
  Origin origin;
};

/// All that was to be timed; of a request, the id ends in "/request:<name>"; of a peer, it
/// is "peer:<name>".
std::map<CellKey, Timing> timings(const Record& record);

/// The speed-up of one cell over another, or the mark of the one that has no number.
struct MeasuredSpeedUp {
  std::optional<SpeedUp> speed_up;
  std::string mark;
};

MeasuredSpeedUp measured_speed_up(const Record& record, const CellKey& reference,
                                  const CellKey& variant);
MeasuredSpeedUp measured_speed_up(const Measured& reference, const Measured& variant);

/// The mean speed-up of one of the paper's variants over another (both by position in `variants`)
/// within a family, over those of the sizes where both were measured.
struct MeanSpeedUp {
  std::optional<SpeedUp> speed_up;
  std::size_t sizes = 0;  ///< that went into it
};

MeanSpeedUp mean_speed_up(const Record& record, std::string_view family, std::size_t reference,
                          std::size_t variant, std::span<const std::int64_t> sizes);

/// Sizes recorded for a case, in whatever state, ascending.
std::vector<std::int64_t> recorded_sizes(const Record& record, std::string_view case_name);

/// The sparse families that the record has a cell of, in whatever state: a build without a backend
/// has none of it, and no table shows it.
std::vector<std::string_view> recorded_families(const Record& record);

/// How ours and the paper's values are told apart: "ours" and "paper" when both are times of the
/// same motion, "ours, 2 s" and "paper, 30 s" when they are not.
struct Sources {
  std::string ours;
  std::string paper;
  std::string warning;        ///< why the times cannot be compared; empty when they can
  std::string ratio_warning;  ///< likewise, for ratios of them
};

Sources sources(const Record& record);

/// Whether times are taken from all samples of segments, as since 1.6.0.
bool has_samples_of_segments(const Record& record);

/// What the times of a record are, in the words of its notes: records before 1.4.0 have medians,
/// later ones segments.
struct TimeWords {
  std::string time;        ///< "median"
  std::string times;       ///< "medians"
  std::string interval;    ///< "[its interval]"
  std::string definition;  ///< a note; empty where the words need none
};

TimeWords time_words(const Record& record);

/// For the beginning of a sentence.
std::string capitalised(std::string text);

/// Adds the definition to the notes of a table that uses the words.
void define_time(Table& table, const Record& record);

/// "5 repetitions", "3 to 5 repetitions", "1 repetition": of all cells that were measured.
std::string repetitions(const Record& record);

/// Why there is no time; empty when there is one.
std::string remark(Status status, const std::string& message);

/// What inconclusive_mark means, for the notes of a table.
std::string inconclusive_note();

/// Adds a reservation about what the entry shows.
void add_note(Entry& entry, const std::string& note);

/// "0.4210 ±0.0020", quantities {seconds, half_range, repetitions}; or the mark.
Entry seconds_entry(const Measured& measured);

/// "0.1122 [0.1085, 0.1185]", quantities {seconds, low, high, repetitions}: with its interval; or
/// the mark.
Entry interval_entry(const Measured& measured);

/// So many significant digits, or the mark of what is missing.
Entry number_entry(const std::optional<double>& value, int significant);

/// A number of things, in full.
Entry count_entry(std::size_t count);

/// "1.24 [1.21, 1.27] (19.4 %)", quantities {speed_up, low, high, percent}, with inconclusive_mark
/// where the interval is too wide; or the mark.
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
