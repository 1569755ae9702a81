#include "report/tables/entries.h"

#include <algorithm>

namespace desmo::report {

void add_note(Entry& entry, const std::string& note) {
  entry.shown += (entry.note.empty() ? " " : ", ") + note;
  entry.note += (entry.note.empty() ? "" : ", ") + note;
}

Entry seconds_entry(const Measured& measured, Spread spread) {
  if (!measured.seconds) return note_entry(measured.mark);
  const SampleSummary& s = *measured.seconds;
  const DigitStyle style = significant_digits(s.value, 4);
  const std::string count = std::to_string(s.count);
  const bool is_range = spread == Spread::range;
  if (!s.has_interval()) {
    const std::string order = write_order(s.value);
    return is_range ? composed("{}", {order, "", "", count}) : composed("{}", {order, "", count});
  }
  const std::string value = write(s.value, style), median = write(s.median, style);
  if (is_range)
    return composed("{} ({} – {})", {value, write(s.least, style), write(s.largest, style), count});
  if (spread == Spread::half_range)
    return composed("{} ±{}", {value, write(s.half_range(), style), count});
  if (median == value) return composed("{}", {value, "", count});
  return composed("{} (median {})", {value, median, count});
}

Entry number_entry(const std::optional<double>& value, int significant) {
  return value ? digits_entry(write_significant(*value, significant)) : note_entry(missing_mark);
}

Entry reference_entry() { return composed("{}", {"1.00"}, "reference"); }

Entry instant_entry(const Record& record, const Measured& measured, int significant) {
  if (!measured.seconds) return note_entry(missing_mark);
  const double microseconds =
      1e6 * measured.seconds->value / static_cast<double>(record.settings.instants);
  if (!measured.seconds->has_interval()) return digits_entry(write_order(microseconds));
  return number_entry(microseconds, significant);
}

void add_errors(std::vector<Entry>& row, const Measurement& candidate) {
  const auto& checked = candidate.verification;
  for (double LevelNumbers::*level :
       {&LevelNumbers::position, &LevelNumbers::velocity, &LevelNumbers::acceleration})
    row.push_back(number_entry(checked ? std::optional((*checked).*level) : std::nullopt, 2));
}

std::string ratio_text(const SpeedUp& ratio) {
  return ratio.has_interval ? write(ratio.value, ratio_digits(ratio.value))
                            : write_order(ratio.value);
}

Entry ratio_entry(const SpeedUp& ratio, bool with_percent) {
  const DigitStyle style = ratio_digits(ratio.value);
  std::string form = "{}";
  std::vector<std::string> digits{ratio_text(ratio), "", ""};
  if (ratio.has_interval) {
    form += " [{}, {}]";
    digits = {digits[0], write(ratio.low, style), write(ratio.high, style)};
  }
  if (with_percent) {
    const bool shown =
        ratio.has_interval && ratio.percent >= 0;  // a slower variant has no percentage
    digits.push_back(shown ? write_fixed(ratio.percent, 1) : "");
    if (shown) form += " ({} %)";
  }
  return composed(form, digits, ratio.inconclusive() ? inconclusive_mark : "");
}

Entry ratio_entry(const MeasuredSpeedUp& measured, bool with_percent) {
  return measured.speed_up ? ratio_entry(*measured.speed_up, with_percent)
                           : note_entry(measured.mark);
}

Entry step_time_entry(const Time& step) {
  const SampleSummary time = summarise(step);
  if (time.count < 2) return composed("{}", {write_order(time.value * 1e6), ""});
  const DigitStyle style = significant_digits(time.value * 1e6, 4);
  return composed("{} – {}",
                  {write(time.value * 1e6, style), write(*time.without_best * 1e6, style)});
}

Entry error_entry(const std::optional<double>& error) {
  if (!error) return note_entry(missing_mark);
  return digits_entry(write(*error, {.scientific = true, .decimals = 1}));
}

Table excerpt(const Table& table, Table head,
              const std::function<bool(const std::vector<Entry>&)>& keep) {
  constexpr std::size_t max_rows = 14;
  std::vector<std::size_t> places;
  for (Column& column : head.columns) {
    const auto found = std::ranges::find(table.columns, column.name, &Column::name);
    places.push_back(static_cast<std::size_t>(found - table.columns.begin()));
    column.quantities = found->quantities;
  }
  for (const auto& row : table.rows) {
    if (head.rows.size() == max_rows) break;
    if (!keep(row)) continue;
    auto& kept = head.rows.emplace_back();
    for (const std::size_t place : places) kept.push_back(row[place]);
  }
  return head;
}

}  // namespace desmo::report
