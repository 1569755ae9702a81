#include "report/tables/entries.h"

#include <charconv>

#include "report/statistics/paper.h"
#include "report/statistics/variants.h"
#include "report/text/digits.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

// Printed digits; nothing when there are none.
std::optional<double> number(const std::string& digits) {
  double value = 0;
  const char* end = digits.data() + digits.size();
  if (std::from_chars(digits.data(), end, value).ec != std::errc()) return std::nullopt;
  return value;
}

std::string runs(std::size_t repetitions) { return repetitions == 1 ? "one run" : "two runs"; }

/// Shows a time with what says how far it varies: a quantity, and how that is shown.
template <class Variation>
Entry time_entry(const Measured& measured, const Variation& variation) {
  if (!measured.seconds) return note_entry(measured.mark);
  const Summary& seconds = *measured.seconds;
  const DigitStyle style = significant_digits(seconds.value, 4);
  const std::string value = write(seconds.value, style), count = std::to_string(seconds.count);
  if (!seconds.has_interval())
    return {value + " (" + runs(seconds.count) + ")", {value, "", count}, runs(seconds.count)};
  const auto& [quantity, shown] = variation(seconds, value, style);
  return {value + shown, {value, quantity, count}, {}};
}

}  // namespace

void add_note(Entry& entry, const std::string& note) {
  entry.shown += (entry.note.empty() ? " " : ", ") + note;
  entry.note += (entry.note.empty() ? "" : ", ") + note;
}

Entry seconds_entry(const Measured& measured) {
  return time_entry(measured, [](const Summary& seconds, const std::string&, DigitStyle style) {
    const std::string half = write(seconds.half_range(), style);
    return std::pair(half, " ±" + half);
  });
}

Entry median_entry(const Measured& measured) {
  return time_entry(measured,
                    [](const Summary& seconds, const std::string& value, DigitStyle style) {
                      const std::string median = write(seconds.median, style);
                      if (median == value) return std::pair(std::string(), std::string());
                      return std::pair(median, " (median " + median + ")");
                    });
}

Entry digits_entry(std::string digits) { return {digits, {digits}, {}}; }

Entry number_entry(const std::optional<double>& value, int significant) {
  return value ? digits_entry(write_significant(*value, significant)) : note_entry(missing_mark);
}

Entry count_entry(std::size_t count) { return digits_entry(std::to_string(count)); }

Entry reference_entry() { return {"1.00 reference", {"1.00"}, "reference"}; }

Entry instant_entry(const Record& record, const Measured& measured, int significant) {
  if (!measured.seconds) return note_entry(missing_mark);
  return number_entry(1e6 * measured.seconds->value / static_cast<double>(record.settings.instants),
                      significant);
}

void add_errors(std::vector<Entry>& row, const Candidate& candidate) {
  const auto& checked = candidate.verification;
  for (double PerLevel::*level :
       {&PerLevel::position, &PerLevel::velocity, &PerLevel::acceleration})
    row.push_back(number_entry(checked ? std::optional((*checked).*level) : std::nullopt, 2));
}

Entry speed_up_entry(const MeasuredSpeedUp& measured) {
  if (!measured.speed_up) return note_entry(measured.mark);
  Entry entry = ratio_entry(*measured.speed_up);
  if (measured.speed_up->percent < 0) {  // slower: the ratio says it
    entry.digits.emplace_back();
    return entry;
  }
  const std::string percent = write_fixed(measured.speed_up->percent, 1);
  entry.shown.insert(entry.shown.size() - (entry.note.empty() ? 0 : entry.note.size() + 1),
                     " (" + percent + " %)");
  entry.digits.push_back(percent);
  return entry;
}

Entry without_percent(Entry entry) {
  if (!entry.has_number()) return entry;
  const std::string tail = " (" + entry.digits.back() + " %)";
  if (const std::size_t begin = entry.shown.find(tail); begin != entry.shown.npos)
    entry.shown.erase(begin, tail.size());
  entry.digits.pop_back();
  return entry;
}

Entry ratio_entry(const SpeedUp& ratio) {
  const DigitStyle style = ratio_digits(ratio.value);
  const std::string value = write(ratio.value, style);
  if (!ratio.spread) {
    Entry entry{value, {value, "", ""}, {}};
    add_note(entry, runs(ratio.repetitions));
    return entry;
  }
  const std::string low = write(ratio.low, style), high = write(ratio.high, style);
  Entry entry{value + " [" + low + ", " + high + "]", {value, low, high}, {}};
  if (ratio.inconclusive()) add_note(entry, inconclusive_mark);
  return entry;
}

Entry ratio_entry(const MeasuredSpeedUp& measured) {
  return measured.speed_up ? ratio_entry(*measured.speed_up) : note_entry(measured.mark);
}

// With fewer sizes than the paper's it cannot stand beside the paper's, and says so.
Entry mean_speed_up_entry(const Record& record, std::string_view family, std::size_t variant) {
  const std::vector<std::int64_t>& sizes = published_sizes();
  const MeanSpeedUp mean = mean_speed_up(record, family, truck_global, variant, sizes);
  if (!mean.speed_up) return note_entry(missing_mark);
  Entry entry = speed_up_entry({mean.speed_up, {}});
  if (mean.sizes == sizes.size()) return entry;
  add_note(entry, "incomplete " + std::to_string(mean.sizes) + "/" + std::to_string(sizes.size()));
  return entry;
}

Entry compared(Entry published, const Entry& ours) {
  const bool incomplete = ours.note.find("incomplete") != std::string::npos;
  if (!published.has_number() || incomplete || ours.digits.size() < 3) return published;
  const std::optional<double> value = number(published.digits[0]), low = number(ours.digits[1]),
                              high = number(ours.digits[2]);
  if (!value || !low || !high) return published;
  published.note = *low <= *value && *value <= *high ? inside_mark : outside_mark;
  published.shown += " " + published.note;
  return published;
}

Entry step_time_entry(const std::vector<double>& samples) {
  const StepTime time = step_time(samples);
  const DigitStyle style = significant_digits(time.seconds * 1e6, 4);
  const std::string least = write(time.seconds * 1e6, style);
  if (samples.size() < 2) return {least + " (one run)", {least, ""}, "one run"};
  const std::string again = write(time.again * 1e6, style);
  return {least + " – " + again, {least, again}, {}};
}

Entry step_time_entry(const NamedPoint* point) {
  return point ? step_time_entry(point->second.seconds_per_step) : note_entry(missing_mark);
}

Entry step_ratio_entry(const NamedPoint* reference, const NamedPoint* variant) {
  if (!reference || !variant) return note_entry(missing_mark);
  if (reference == variant) return reference_entry();
  return ratio_entry(speed_up(*reference, *variant));
}

Entry error_entry(const std::optional<double>& error) {
  if (!error) return note_entry(missing_mark);
  return digits_entry(write(*error, {.scientific = true, .decimals = 1}));
}

Entry error_entry(const NamedPoint* point) {
  return error_entry(point ? std::optional(position_error(*point)) : std::nullopt);
}

Entry iterations_entry(const NamedPoint* point) {
  return number_entry(point ? std::optional(point->second.iterations_per_step) : std::nullopt, 3);
}

Entry stop_entry(const NamedPoint* point) {
  if (!point) return sentence("costs.no_stop");
  const auto& [iterations, tolerance] =
      std::pair(point->second.configuration.iterations, point->second.configuration.tolerance);
  if (iterations.empty() && tolerance.empty()) return sentence("costs.usual_stop");
  const std::string count = sentence(iterations == "1" ? "costs.one_iteration" : "costs.iterations",
                                     {{"count", iterations}}),
                    limit = sentence("costs.tolerance", {{"tolerance", tolerance}});
  if (tolerance.empty()) return count;
  return iterations.empty() ? limit : count + ", " + limit;
}

}  // namespace desmo::report
