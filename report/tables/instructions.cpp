// Tables of instructions of a step, which are repeatable where times are not: those of a record,
// and those of one commit after the other.
#include <algorithm>
#include <cmath>
#include <map>

#include "report/tables/entries.h"
#include "report/tables/tables.h"

namespace desmo::report {
namespace {

using Counted = std::pair<const CandidateKey, StepCount>;

/// Returns the paper's name of a formulation; empty where it has none.
std::string paper_name(const CandidateKey& key) {
  for (const PaperVariant& variant : paper_variants)
    for (const std::string_view family : sparse_families)
      if (variant.case_name == key.case_name &&
          family_key(variant, key.coordinates, family).id == key.id)
        return family_name(variant, family);
  return {};
}

/// Returns the entry of the reference's number of instructions, divided by that of `counted`:
/// "15.71".
Entry times_fewer(const Counted* reference, const Counted* counted) {
  if (!reference) return note_entry(missing_mark);
  if (counted == reference) return reference_entry();
  const double ratio = static_cast<double>(reference->second.instructions) /
                       static_cast<double>(counted->second.instructions);
  return digits_entry(write(ratio, ratio_digits(ratio)));
}

/// Shows the counts of one case and size, the fewest first.
Table instructions_table(const TextValues& place, std::vector<const Counted*> counts) {
  std::ranges::stable_sort(counts, {}, [](const Counted* c) { return c->second.instructions; });
  const auto reference =
      std::ranges::find(counts, usual_reference, [](const Counted* c) { return c->first.id; });
  TextValues values = place;
  values.emplace_back("tool", counts.front()->second.tool);
  Table table = headed_table("instructions_case", values);
  for (const Counted* counted : counts)
    table.rows.push_back({counted->first.id, paper_name(counted->first),
                          counted->second.instructions,
                          times_fewer(reference == counts.end() ? nullptr : *reference, counted),
                          counted->second.steps});
  return table;
}

}  // namespace

std::vector<Section> instructions_sections(const Record& record) {
  std::map<CaseSize, std::vector<const Counted*>> places;
  for (const Counted& counted : record.instructions) places[counted.first].push_back(&counted);
  Section front, section = headed_section("instructions");
  for (const auto& [place, counts] : places) {
    TextValues values{{"case", place.case_name}, {"coordinates", place.coordinates}};
    const Table& table = section.tables.emplace_back(instructions_table(values, counts));
    const bool truck = place.case_name == truck_case;
    if (!front.tables.empty() && !truck) continue;
    const std::vector<Entry>& top = table.rows.front();
    values.insert(values.end(),
                  {{"id", top[0].shown},
                   {"count", top[2].shown},
                   {"times", top[3].digits.empty() ? missing_mark : top[3].digits.front()},
                   {"formulations", table.rows.size()}});
    front = headed_section("instructions_front", values,
                           {excerpt(table, headed_table("instructions_in_short", values))});
  }
  return {front, section};
}

namespace {

constexpr double marked = 0.02;  // a commit is listed when |relative change of a candidate| > this

std::string percent_of(double change) { return write_change(100 * change); }

}  // namespace

Section history_section(const History& history) {
  Table lines = headed_table("history"), moves = headed_table("history_moves");
  for (const std::string& candidate : history.candidates)
    lines.columns.push_back({candidate, {"relative"}});
  std::map<std::size_t, double> first, last;
  std::int64_t number = 0;
  for (const HistoryPoint& point : history.points) {
    const std::string date = point.date.substr(0, 10);
    std::vector<Entry>& row = lines.rows.emplace_back();
    row = {++number, point.commit, date, point.title};
    for (std::size_t i = 0; i < history.candidates.size(); ++i) {
      if (!point.instructions[i]) {
        row.push_back(note_entry(missing_mark));
        continue;
      }
      const auto count = static_cast<double>(*point.instructions[i]);
      row.push_back(number_entry(count / first.try_emplace(i, count).first->second, 4));
      const double before = last.try_emplace(i, count).first->second, change = count / before - 1;
      last[i] = count;
      if (std::abs(change) <= marked) continue;
      add_note(row.back(), "moved");
      moves.rows.push_back({point.commit, date, point.title, history.candidates[i],
                            static_cast<std::int64_t>(before), *point.instructions[i],
                            composed("{} %", {percent_of(change)})});
    }
  }
  std::vector<double> changes{0};  // relative change of each candidate since its first count, and 0
  for (const auto& [candidate, count] : last) changes.push_back(count / first[candidate] - 1);
  return headed_section(
      "history_section",
      {{"commits", history.points.size()},
       {"candidates", history.candidates.size()},
       {"fewer", std::ranges::count_if(changes, [](double change) { return change < 0; })},
       {"more", std::ranges::count_if(changes, [](double change) { return change > 0; })},
       {"fall", percent_of(std::ranges::min(changes))},
       {"rise", percent_of(std::ranges::max(changes))}},
      {std::move(lines), std::move(moves)});
}

}  // namespace desmo::report
