#include "report/comparison.h"

#include <algorithm>

#include "report/statistics/compared_times.h"
#include "report/statistics/measurements.h"
#include "report/tables/entries.h"
#include "report/tables/time_words.h"

namespace desmo::report {
namespace {

std::string origin(const std::string& name, const Record& record) {
  return name + ": " + record.date + ", commit " + record.commit +
         (record.dirty ? " with uncommitted changes" : "") + ", " + record.machine.cpu;
}

std::vector<std::string> origins(const Record& first, const Record& second) {
  return {origin("A", first), origin("B", second)};
}

/// How many of some that the others have not: "3 in A only, 0 in B only".
std::string unshared(const TimedGroup& a, const TimedGroup& b) {
  const auto only = [](const TimedGroup& in, const TimedGroup& other) {
    return std::to_string(std::ranges::count_if(
        in.timings, [&](const auto& entry) { return !other.timings.contains(entry.first); }));
  };
  return only(a, b) + " in A only, " + only(b, a) + " in B only";
}

Timing timing_of(const std::map<CandidateKey, Timing>& all, const CandidateKey& key) {
  const auto found = all.find(key);
  if (found != all.end()) return found->second;
  return {{std::nullopt, missing_mark}, {}, {}};
}

std::string remarks(const Timing& a, const Timing& b) {
  std::string text = a.remark.empty() ? "" : "A: " + a.remark;
  if (!b.remark.empty()) text += (text.empty() ? "B: " : "; B: ") + b.remark;
  return text;
}

std::vector<Entry> names_of(const CandidateKey& key) {
  return {text_entry(key.case_name), text_entry(std::to_string(key.coordinates)),
          text_entry(key.id)};
}

Table seconds_beside(const TimedGroup& a, const TimedGroup& b, const Record& first) {
  const std::vector<std::string> seconds{"seconds", "half_range", "repetitions"};
  const TimeWords words = time_words(first);
  Table table{
      .name = a.name,
      .title = a.what + " of A and B",
      .notes = {capitalised(words.time) +
                    " ± half the range. A over B: how many times as fast B is, ratio of "
                    "the " +
                    words.times + " [its interval] (time saved); " + inconclusive_note() + ".",
                "Not shown: " + unshared(a, b) + "."},
      .columns = {{"case", {}},
                  {"coordinates", {}},
                  {"id", {}},
                  {"A", seconds},
                  {"B", seconds},
                  {"A over B", {"speed_up", "low", "high", "percent"}},
                  {"remark", {}}},
      .rows = {}};
  define_time(table, first);
  for (const auto& [key, one] : a.timings) {
    const auto found = b.timings.find(key);
    if (found == b.timings.end()) continue;
    const Timing& other = found->second;
    std::vector<Entry> row = names_of(key);
    row.insert(row.end(), {seconds_entry(one.time), seconds_entry(other.time),
                           speed_up_entry(measured_speed_up(one.time, other.time)),
                           text_entry(remarks(one, other))});
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// What may be shown of a key in a record: nothing of a reference, which is 1 everywhere.
std::optional<SpeedUp> speed_up_of(const TimedGroup& group, const CandidateKey& key) {
  const CandidateKey reference = reference_of(key);
  if (reference == key) return std::nullopt;
  return measured_speed_up(timing_of(group.timings, reference).time,
                           timing_of(group.timings, key).time)
      .speed_up;
}

Table speed_ups_beside(const TimedGroup& a, const TimedGroup& b) {
  const std::vector<std::string> ratio{"ratio", "low", "high"};
  Table table{
      .name = "machines" + a.name.substr(std::string("comparison").size()),
      .title = "Speed-ups of two machines: " + a.what,
      .notes = {"Times as fast as the reference of the same case, size and request on the "
                "same machine [its interval]; the reference is global_automatic_klu, of "
                "several threads the same analysis on one; " +
                inconclusive_note() + "."},
      .columns = {{"case", {}}, {"coordinates", {}}, {"id", {}}, {"A", ratio}, {"B", ratio}},
      .rows = {}};
  for (const auto& [key, timing] : a.timings) {
    const std::optional<SpeedUp> one = speed_up_of(a, key), other = speed_up_of(b, key);
    if (!one || !other) continue;
    std::vector<Entry> row = names_of(key);
    row.insert(row.end(), {ratio_entry(*one), ratio_entry(*other)});
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table counts_beside(const Record& first, const Record& second) {
  Table table{.name = "comparison_instructions",
              .title = "Instructions of a step in A and B",
              .notes = {"A over B: how many times as many A takes."},
              .columns = {{"case", {}},
                          {"coordinates", {}},
                          {"id", {}},
                          {"A", {"instructions"}},
                          {"B", {"instructions"}},
                          {"A over B", {"ratio"}}},
              .rows = {}};
  for (const auto& [key, count] : first.instructions) {
    const auto other = second.instructions.find(key);
    if (other == second.instructions.end()) continue;
    const auto a = static_cast<double>(count.instructions),
               b = static_cast<double>(other->second.instructions);
    std::vector<Entry> row = names_of(key);
    row.insert(row.end(), {count_entry(static_cast<std::size_t>(count.instructions)),
                           count_entry(static_cast<std::size_t>(other->second.instructions)),
                           number_entry(a / b, 3)});
    table.rows.push_back(std::move(row));
  }
  return table;
}

void add(Section& section, Table table) {
  if (!table.rows.empty()) section.tables.push_back(std::move(table));
}

/// As of a record without timing windows.
Record without_windows(Record record) {
  record.settings.windows.reset();
  for (auto& [key, candidate] : record.candidates) candidate.time.windows = {};
  for (Request& request : record.requests) request.time.windows = {};
  for (Peer& peer : record.peers) peer.candidate.time.windows = {};
  return record;
}

}  // namespace

Document make_comparison(const Record& first, const Record& second) {
  if (first.settings.windows != second.settings.windows)  // then there is nothing to pair
    return make_comparison(without_windows(first), without_windows(second));
  Section section{"Two runs", origins(first, second), {}};
  const std::vector<TimedGroup> a = timed_groups(first), b = timed_groups(second);
  for (std::size_t i = 0; i < a.size(); ++i) add(section, seconds_beside(a[i], b[i], first));
  add(section, counts_beside(first, second));
  return {.title = "desmo: one run beside another", .sections = {std::move(section)}};
}

Document make_comparison_of_machines(const Record& first, const Record& second) {
  Section section{"Two machines", origins(first, second), {}};
  const std::vector<TimedGroup> a = timed_groups(first), b = timed_groups(second);
  for (std::size_t i = 0; i < a.size(); ++i) add(section, speed_ups_beside(a[i], b[i]));
  add(section, counts_beside(first, second));
  return {.title = "desmo: one machine beside another", .sections = {std::move(section)}};
}

}  // namespace desmo::report
