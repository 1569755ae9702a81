// What the figure of growth shows, as a table: the design in report/figures draws these numbers.
#include "report/statistics/caches.h"
#include "report/statistics/selection.h"
#include "report/tables/entries.h"
#include "report/tables/size.h"
#include "report/text/digits.h"

namespace desmo::report {
namespace {

std::vector<Entry> row(const CandidateKey& key, const TimedSize& entry,
                       const std::vector<Cache>& caches) {
  std::vector<Entry> candidates{text_entry(key.case_name), text_entry(key.id),
                                text_entry(std::to_string(key.coordinates))};
  if (entry.status != Status::ok) {
    candidates.push_back(note_entry(failed_mark));
    for (int i = 0; i < 5; ++i) candidates.push_back(note_entry(missing_mark));
    candidates.push_back(text_entry(""));
    candidates.push_back(text_entry(entry.message));
    return candidates;
  }
  const double seconds = step_time(entry.seconds_per_step).seconds;
  const auto kibibytes = [](std::optional<double> bytes) {
    return number_entry(bytes ? std::optional(*bytes / 1024) : std::nullopt, 4);
  };
  candidates.push_back(step_time_entry(entry.seconds_per_step));
  candidates.push_back(number_entry(1e9 * seconds / static_cast<double>(key.coordinates), 4));
  candidates.push_back(kibibytes(entry.bytes));
  candidates.push_back(kibibytes(entry.state_bytes));
  candidates.push_back(number_entry(entry.iterations_per_step, 3));
  candidates.push_back(error_entry(entry.verification->position));
  candidates.push_back(text_entry(entry.bytes ? held_by(caches, *entry.bytes) : ""));
  candidates.push_back(text_entry("checked against " + entry.checked_against + " precision"));
  return candidates;
}

}  // namespace

Table growth_data(const Record& record) {
  Table table{.name = "growth",
              .title = "What a coordinate costs a step, by the memory of the formulation",
              .notes = {"Ours: " + record.machine.cpu + ", " + record.date +
                            ". Growth is linear where a coordinate costs the same.",
                        "Memory: all that the formulation keeps, libraries included; a step "
                        "touches less. Vertical: the caches of the machine, as far as it tells.",
                        step_time_note()},
              .columns = {{"case", {}},
                          {"id", {}},
                          {"coordinates", {}},
                          {"µs/step", {"microseconds", "again"}},
                          {"ns/coordinate", {"nanoseconds"}},
                          {"memory KiB", {"kibibytes"}},
                          {"q, q', q'' KiB", {"kibibytes"}},
                          {"iterations/step", {"iterations"}},
                          {"error q", {"error"}},
                          {"memory is", {}},
                          {"remark", {}}},
              .rows = {},
              .detail = true,
              .figure = true};
  const std::vector<Cache> caches = data_caches(record.machine);
  for (const auto& [key, entry] : record.growth) table.rows.push_back(row(key, entry, caches));
  return table;
}

}  // namespace desmo::report
