// Where the time of a step goes.
#include "report/tables/entries.h"
#include "report/tables/tables.h"
#include "report/text/digits.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

Entry phase_entry(double seconds, double total) {
  const std::string microseconds = write_significant(seconds * 1e6, 3),
                    percent = write_fixed(total > 0 ? 100 * seconds / total : 0, 0);
  return {microseconds + " (" + percent + " %)", {microseconds, percent}, {}};
}

/// Shows half the range of the total, as next to the times of table 1.
Entry total_entry(const Profile& profile, double total) {
  const DigitStyle style = significant_digits(total * 1e6, 4);
  const std::string microseconds = write(total * 1e6, style);
  if (!profile.total_range) return {microseconds, {microseconds, ""}, {}};
  const auto [least, largest] = *profile.total_range;
  const std::string half = write((largest - least) / 2 * 1e6, style);
  return {microseconds + " ±" + half, {microseconds, half}, {}};
}

}  // namespace

Table time_split(const Record& record) {
  Table table = headed_table("time_split");
  for (const char* phase : phases) table.columns.push_back({phase, {"microseconds", "percent"}});
  for (const auto& [key, profile] : record.profiles) {
    const bool failed = measured(record, key).mark == failed_mark;
    double total = 0;
    for (const double seconds : profile.seconds_per_step) total += seconds;
    std::vector<Entry> row{key.case_name, key.coordinates, key.id,
                           failed ? note_entry(failed_mark) : total_entry(profile, total)};
    for (const double seconds : profile.seconds_per_step)
      row.push_back(failed ? note_entry(failed_mark) : phase_entry(seconds, total));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace desmo::report
