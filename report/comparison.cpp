#include "report/comparison.h"

#include <set>

#include "report/entries.h"
#include "report/measurements.h"
#include "report/time_words.h"

namespace desmo::report {
namespace {

std::string origin(const std::string& name, const Record& record) {
  return name + ": " + record.date + ", commit " + record.commit +
         (record.dirty ? " with uncommitted changes" : "");
}

Timing timing_of(const std::map<CellKey, Timing>& all, const CellKey& key) {
  const auto found = all.find(key);
  if (found != all.end()) return found->second;
  return {{std::nullopt, missing_mark}, {}, {}};
}

std::string remarks(const Timing& a, const Timing& b) {
  std::string text = a.remark.empty() ? "" : "A: " + a.remark;
  if (!b.remark.empty()) text += (text.empty() ? "B: " : "; B: ") + b.remark;
  return text;
}

Entry ratio_entry(const Timing& a, const Timing& b) {
  return speed_up_entry(measured_speed_up(a.time, b.time));
}

/// As of a record without timing windows.
Record without_windows(Record record) {
  record.settings.windows.reset();
  for (auto& [key, cell] : record.cells) cell.time.windows = {};
  for (Request& request : record.requests) request.time.windows = {};
  for (Peer& peer : record.peers) peer.cell.time.windows = {};
  return record;
}

}  // namespace

Document make_comparison(const Record& first, const Record& second) {
  if (first.settings.windows != second.settings.windows)  // then there is nothing to pair
    return make_comparison(without_windows(first), without_windows(second));
  const TimeWords words = time_words(first);
  const std::vector<std::string> seconds{"seconds", "half_range", "repetitions"};
  Table table{.name = "comparison",
              .title = "CPU seconds of A and B",
              .notes = {capitalised(words.time) +
                        " ± half the range. A over B: how many times as fast B is, ratio of the " +
                        words.times + " [its interval] (time saved); " + inconclusive_note() + "."},
              .columns = {{"case", {}},
                          {"coordinates", {}},
                          {"id", {}},
                          {"A", seconds},
                          {"B", seconds},
                          {"A over B", {"speed_up", "low", "high", "percent"}},
                          {"remark", {}}},
              .rows = {}};
  define_time(table, first);
  const auto a = timings(first, Clock::cpu), b = timings(second, Clock::cpu);
  std::set<CellKey> keys;
  for (const auto* all : {&a, &b})
    for (const auto& [key, timing] : *all) keys.insert(key);
  for (const CellKey& key : keys) {
    const Timing one = timing_of(a, key), other = timing_of(b, key);
    table.rows.push_back({text_entry(key.case_name), text_entry(std::to_string(key.coordinates)),
                          text_entry(key.id), seconds_entry(one.time), seconds_entry(other.time),
                          ratio_entry(one, other), text_entry(remarks(one, other))});
  }
  return {.title = "desmo: one run beside another",
          .sections = {{"Two runs", {origin("A", first), origin("B", second)}, {table}}}};
}

}  // namespace desmo::report
