// Instructions a step, commit by commit: exact, and independent of the machine.
#include <cmath>
#include <map>

#include "report/tables/entries.h"
#include "report/tables/tables.h"
#include "report/text/digits.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

constexpr double marked = 0.02;  // change of a cell from which on a commit is named

std::string percent_of(double change) {
  return (change > 0 ? "+" : "") + write_fixed(100 * change, 1);
}

}  // namespace

Section history_section(const History& history) {
  Section section = headed_section("history_section");
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
      const std::string percent = percent_of(change);
      moves.rows.push_back({point.commit,
                            date,
                            point.title,
                            history.candidates[i],
                            count_entry(static_cast<std::size_t>(before)),
                            count_entry(static_cast<std::size_t>(count)),
                            {percent + " %", {percent}, {}}});
    }
  }
  section.tables = {std::move(lines), std::move(moves)};
  return section;
}

}  // namespace desmo::report
