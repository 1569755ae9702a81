// What a step costs with all unknowns at once, by their number.
#include <map>
#include <set>

#include "report/statistics/selection.h"
#include "report/tables/size.h"

namespace desmo::report {

Table break_even_times(const Record& record, const std::string& name) {
  Table table{.name = "break_even_" + name,
              .title = "µs a step, all unknowns at once: " + name,
              .notes = {step_time_note()},
              .columns = {{"unknowns", {}}},
              .rows = {},
              .detail = true};
  std::set<std::string> ids;
  std::map<std::int64_t, std::map<std::string, const TimedSize*>> sizes;
  for (const auto& [key, entry] : record.break_even)
    if (key.case_name == name) {
      ids.insert(key.id);
      sizes[entry.unknowns][key.id] = &entry;
    }
  for (const std::string& id : ids) table.columns.push_back({id, {"microseconds", "again"}});
  for (const auto& [unknowns, entries] : sizes) {
    std::vector<Entry> row{text_entry(std::to_string(unknowns))};
    for (const std::string& id : ids) {
      const auto found = entries.find(id);
      row.push_back(found == entries.end() ? note_entry(missing_mark)
                    : found->second->status != Status::ok
                        ? note_entry(failed_mark)
                        : step_time_entry(found->second->seconds_per_step));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace desmo::report
