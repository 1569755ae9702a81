#include <algorithm>

#include "report/report.h"
#include "report/statistics/comparability.h"
#include "report/statistics/measurements.h"
#include "report/tables/entries.h"
#include "report/tables/record_words.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

std::vector<std::string> origins(const Record& first, const Record& second) {
  std::vector<std::string> lines;
  for (const auto& [name, record] : {std::pair{"A", &first}, {"B", &second}})
    lines.push_back(sentence("comparison.origin", {{"name", name},
                                                   {"date", record->date},
                                                   {"commit", commit_of(*record)},
                                                   {"cpu", record->machine.cpu}}));
  return lines;
}

/// Counts what one has and the other has not.
std::int64_t only_in(const TimedGroup& group, const TimedGroup& other) {
  return std::ranges::count_if(
      group.timings, [&](const auto& entry) { return !other.timings.contains(entry.first); });
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
  return {key.case_name, key.coordinates, key.id};
}

Table seconds_of_both(const TimedGroup& a, const TimedGroup& b, const Record& first) {
  Table table = headed_table("comparison", {{"name", a.name},
                                            {"what", a.what},
                                            {"time", time_word(first)},
                                            {"only_a", only_in(a, b)},
                                            {"only_b", only_in(b, a)}});
  define_time(table, first);
  for (const auto& [key, one] : a.timings) {
    const auto found = b.timings.find(key);
    if (found == b.timings.end()) continue;
    const Timing& other = found->second;
    std::vector<Entry> row = names_of(key);
    row.insert(row.end(),
               {seconds_entry(one.time), seconds_entry(other.time),
                speed_up_entry(measured_speed_up(one.time, other.time)), remarks(one, other)});
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

Table speed_ups_of_both(const TimedGroup& a, const TimedGroup& b) {
  Table table = headed_table(
      "machines",
      {{"name", a.name.substr(std::string_view("comparison").size())}, {"what", a.what}});
  for (const auto& [key, timing] : a.timings) {
    const std::optional<SpeedUp> one = speed_up_of(a, key), other = speed_up_of(b, key);
    if (!one || !other) continue;
    std::vector<Entry> row = names_of(key);
    row.insert(row.end(), {ratio_entry(*one), ratio_entry(*other)});
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table counts_of_both(const Record& first, const Record& second) {
  Table table = headed_table("comparison_instructions");
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

}  // namespace

Document make_comparison(const Record& first, const Record& second) {
  Section section{sentence("comparison.section"), origins(first, second), {}};
  const std::vector<TimedGroup> a = timed_groups(first), b = timed_groups(second);
  for (std::size_t i = 0; i < a.size(); ++i) add(section, seconds_of_both(a[i], b[i], first));
  add(section, counts_of_both(first, second));
  return {.title = sentence("comparison.document"), .sections = {std::move(section)}};
}

Document make_comparison_of_machines(const Record& first, const Record& second) {
  Section section{sentence("machines.section"), origins(first, second), {}};
  const std::vector<TimedGroup> a = timed_groups(first), b = timed_groups(second);
  for (std::size_t i = 0; i < a.size(); ++i) add(section, speed_ups_of_both(a[i], b[i]));
  add(section, counts_of_both(first, second));
  return {.title = sentence("machines.document"), .sections = {std::move(section)}};
}

}  // namespace desmo::report
