// Where the time of a step goes.
#include <algorithm>
#include <set>

#include "report/statistics/measurements.h"
#include "report/tables/tables.h"
#include "report/text/digits.h"

namespace desmo::report {
namespace {

// The schema's phases in its order, then what else any profile holds, by name.
std::vector<std::string> phases_of(const Record& record) {
  std::vector<std::string> phases;
  std::set<std::string> known;
  for (const auto& [key, profile] : record.profiles)
    for (const auto& [phase, seconds] : profile.seconds_per_step)
      if (known.insert(phase).second) phases.push_back(phase);
  if (phases.size() > 6) std::sort(phases.begin() + 6, phases.end());
  return phases;
}

Entry phase_entry(const Profile& profile, const std::string& phase, double total) {
  for (const auto& [name, seconds] : profile.seconds_per_step)
    if (name == phase) {
      const std::string microseconds = write_significant(seconds * 1e6, 3);
      const std::string percent = total > 0 ? write_fixed(100 * seconds / total, 0) : "";
      return {microseconds + (percent.empty() ? "" : " (" + percent + " %)"),
              {microseconds, percent},
              {}};
    }
  return note_entry(missing_mark);
}

// Half the range of the total, as beside the times of table 1.
Entry total_entry(const Profile& profile, double total) {
  const DigitStyle style = significant_digits(total * 1e6, 4);
  const std::string microseconds = write(total * 1e6, style);
  if (!profile.total_range) return {microseconds, {microseconds, ""}, {}};
  const auto [least, largest] = *profile.total_range;
  const std::string half = write((largest - least) / 2 * 1e6, style);
  return {microseconds + " ±" + half, {microseconds, half}, {}};
}

// What the profiles of this record are: one pass, or the median of several.
std::string how_measured(const Record& record) {
  const auto repeated =
      std::count_if(record.profiles.begin(), record.profiles.end(),
                    [](const auto& keyed) { return keyed.second.total_range.has_value(); });
  const std::string passes =
      "; where the total has a range, median of several passes ± half the range of "
      "the total";
  return std::string(
             "Wall clock, one instrumented run apart from the tables above, whose parts are slower "
             "than "
             "the timed ones") +
         (repeated > 0 ? passes : "") + ".";
}

}  // namespace

Table time_split(const Record& record) {
  Table table{.name = "time_split",
              .title = "Where the time of a step goes: µs per step and share",
              .notes = {how_measured(record)},
              .columns = {{"case", {}},
                          {"coordinates", {}},
                          {"id", {}},
                          {"total", {"microseconds", "half_range"}}},
              .rows = {}};
  const std::vector<std::string> phases = phases_of(record);
  for (const std::string& phase : phases)
    table.columns.push_back({phase, {"microseconds", "percent"}});
  for (const auto& [key, profile] : record.profiles) {
    std::vector<Entry> row{text_entry(key.case_name), text_entry(std::to_string(key.coordinates)),
                           text_entry(key.id)};
    double total = 0;
    for (const auto& [phase, seconds] : profile.seconds_per_step) total += seconds;
    const bool failed = measured(record, key).mark == failed_mark;
    row.push_back(failed ? note_entry(failed_mark) : total_entry(profile, total));
    for (const std::string& phase : phases)
      row.push_back(failed ? note_entry(failed_mark) : phase_entry(profile, phase, total));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace desmo::report
