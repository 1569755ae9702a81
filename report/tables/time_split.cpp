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

}  // namespace

Table time_split(const Record& record) {
  Table table = headed_table("time_split");
  for (const char* phase : phases) table.columns.push_back({phase, {"microseconds", "percent"}});
  for (const auto& [key, profile] : record.profiles) {
    const bool failed = measured(record, key).mark == failed_mark;
    double total = 0;
    for (const double seconds : profile) total += seconds;
    std::vector<Entry> row{key.case_name, key.coordinates, key.id,
                           failed ? note_entry(failed_mark) : number_entry(1e6 * total, 4)};
    for (const double seconds : profile)
      row.push_back(failed ? note_entry(failed_mark) : phase_entry(seconds, total));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace desmo::report
