#include "report/measurements.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <set>

#include "report/digits.h"
#include "report/paper.h"
#include "report/variants.h"

namespace desmo::report {

namespace {

// Printed digits; nothing when there are none.
std::optional<double> number(const std::string& digits) {
  double value = 0;
  const char* end = digits.data() + digits.size();
  if (std::from_chars(digits.data(), end, value).ec != std::errc()) return std::nullopt;
  return value;
}

Measured measured(Status status, const std::vector<double>& cpu_seconds, const Segments& segments) {
  switch (status) {
    case Status::ok:
      return {summarise(cpu_seconds, segments), {}};
    case Status::failed:
      return {std::nullopt, failed_mark};
    case Status::not_run:
      break;
  }
  return {std::nullopt, not_run_mark};
}

}  // namespace

Measured measured(const Record& record, const CellKey& key) {
  const auto cell = record.cells.find(key);
  if (cell == record.cells.end()) return {std::nullopt, missing_mark};
  return measured(cell->second);
}

Measured measured(const Cell& cell) {
  return measured(cell.status, cell.cpu_seconds, cell.segments);
}

Measured measured(const Request& request) {
  return measured(request.status, request.cpu_seconds, request.segments);
}

std::map<CellKey, Timing> timings(const Record& record) {
  std::map<CellKey, Timing> all;
  for (const auto& [key, cell] : record.cells)
    all[key] = {measured(cell), remark(cell.status, cell.message), cell.origin};
  for (const Request& request : record.requests) {
    CellKey key = request.cell;
    key.id += "/request:" + request.name;
    all[key] = {measured(request), remark(request.status, request.message), request.origin};
  }
  for (const Peer& peer : record.peers)
    all[{peer.case_name, peer.coordinates, "peer:" + peer.name}] = {
        measured(peer.cell), remark(peer.cell.status, peer.cell.message), peer.cell.origin};
  return all;
}

MeasuredSpeedUp measured_speed_up(const Record& record, const CellKey& reference,
                                  const CellKey& variant) {
  return measured_speed_up(measured(record, reference), measured(record, variant));
}

MeasuredSpeedUp measured_speed_up(const Measured& reference, const Measured& variant) {
  if (!variant.seconds) return {std::nullopt, variant.mark};
  if (!reference.seconds) return {std::nullopt, "reference " + reference.mark};
  return {speed_up(*reference.seconds, *variant.seconds), {}};
}

MeanSpeedUp mean_speed_up(const Record& record, std::string_view family, std::size_t reference,
                          std::size_t variant, std::span<const std::int64_t> sizes) {
  std::vector<SpeedUp> found;
  for (const std::int64_t size : sizes) {
    const auto one = measured_speed_up(record, family_key(variants[reference], size, family),
                                       family_key(variants[variant], size, family));
    if (one.speed_up) found.push_back(*one.speed_up);
  }
  if (found.empty()) return {};
  return {mean(found), found.size()};
}

std::vector<std::int64_t> recorded_sizes(const Record& record, std::string_view case_name) {
  std::set<std::int64_t> sizes;
  for (const auto& [key, cell] : record.cells)
    if (key.case_name == case_name) sizes.insert(key.coordinates);
  return {sizes.begin(), sizes.end()};
}

std::vector<std::string_view> recorded_families(const Record& record) {
  std::vector<std::string_view> families;
  for (const std::string_view family : sparse_families)
    if (std::any_of(record.cells.begin(), record.cells.end(), [&](const auto& cell) {
          const std::string& id = cell.first.id;  // group_symbolic_klu/lanes:8
          return id.substr(0, id.find('/')).ends_with("_" + std::string(family));
        }))
      families.push_back(family);
  return families;
}

Sources sources(const Record& record) {
  const double duration = record.settings.duration_seconds;
  if (std::abs(duration - published_duration) < 1e-9) return {"ours", "paper", {}, {}};
  const std::string ours = write_shortest(duration) + " s";
  const std::string paper = write_shortest(published_duration) + " s";
  const std::string motions = "Ours is " + ours + " of motion, the paper's " + paper;
  return {"ours, " + ours, "paper, " + paper, motions + ": these times are not to be compared.",
          motions + ": these are ratios of times of unequal motions."};
}

bool has_samples_of_segments(const Record& record) {
  return std::ranges::any_of(
      record.cells, [](const auto& cell) { return !cell.second.segments.samples.empty(); });
}

namespace {

bool is_whole(const Segments& segments) { return segments.least.size() == 1; }

/// Whether something was solved on several threads.
bool has_threads(const Record& record) {
  return std::ranges::any_of(record.cells,
                             [](const auto& cell) { return is_whole(cell.second.segments); }) ||
         std::ranges::any_of(record.requests,
                             [](const Request& request) { return is_whole(request.segments); });
}

}  // namespace

TimeWords time_words(const Record& record) {
  if (!record.settings.segments) return {"median", "medians", "[its interval]", {}};
  const std::string segments =
      std::to_string(*record.settings.segments) + " equal segments of the motion";
  return {"undisturbed time", "undisturbed times", "[to the median]",
          has_samples_of_segments(record)
              ? "Undisturbed time: of " + segments +
                    " in all repetitions, the lower convex envelope of CPU time over Newton "
                    "updates, both an instant, at the updates of the whole motion" +
                    (has_threads(record) ? "; on several threads the least repetition, by the wall "
                                           "clock. Interval of a "
                                         : ". Interval of a ") +
                    "ratio: without the best repetition of either side."
              : "Undisturbed time: of each of " + segments +
                    " the least CPU time that any repetition took, summed. Interval of a ratio: "
                    "95 %, from how it varies from segment to segment."};
}

std::string capitalised(std::string text) {
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

void define_time(Table& table, const Record& record) {
  const TimeWords words = time_words(record);
  if (!words.definition.empty()) table.notes.push_back(words.definition);
}

std::string repetitions(const Record& record) {
  std::set<std::size_t> counts;
  for (const auto& [key, cell] : record.cells)
    if (cell.status == Status::ok) counts.insert(cell.cpu_seconds.size());
  if (counts.empty()) return "no repetitions";
  const std::string least = std::to_string(*counts.begin());
  const std::string largest = std::to_string(*counts.rbegin());
  return (least == largest ? least : least + " to " + largest) +
         (largest == "1" ? " repetition" : " repetitions");
}

std::string remark(Status status, const std::string& message) {
  if (status == Status::ok) return {};
  return message.empty() ? "no reason recorded" : message;
}

std::string inconclusive_note() {
  return std::string(inconclusive_mark) + ": half the interval of the ratio is more than " +
         write_shortest(100 * widest_conclusive) + " % of it";
}

void add_note(Entry& entry, const std::string& note) {
  entry.shown += (entry.note.empty() ? " " : ", ") + note;
  entry.note += (entry.note.empty() ? "" : ", ") + note;
}

Entry seconds_entry(const Measured& measured) {
  if (!measured.seconds) return note_entry(measured.mark);
  const Summary& seconds = *measured.seconds;
  const DigitStyle style = significant_digits(seconds.value, 4);
  const std::string value = write(seconds.value, style), count = std::to_string(seconds.count);
  if (seconds.count < 2) return {value + " (one run)", {value, "", count}, "one run"};
  const std::string half = write(seconds.half_range(), style);
  return {value + " ±" + half, {value, half, count}, {}};
}

Entry interval_entry(const Measured& measured) {
  if (!measured.seconds) return note_entry(measured.mark);
  const Summary& seconds = *measured.seconds;
  const DigitStyle style = significant_digits(seconds.value, 4);
  const std::string value = write(seconds.value, style), count = std::to_string(seconds.count);
  if (seconds.count < 2) return {value + " (one run)", {value, "", "", count}, "one run"};
  const std::string low = write(seconds.low, style), high = write(seconds.high, style);
  return {value + " [" + low + ", " + high + "]", {value, low, high, count}, {}};
}

Entry number_entry(const std::optional<double>& value, int significant) {
  if (!value) return note_entry(missing_mark);
  const std::string digits = write_significant(*value, significant);
  return {digits, {digits}, {}};
}

Entry count_entry(std::size_t count) {
  const std::string digits = std::to_string(count);
  return {digits, {digits}, {}};
}

Entry speed_up_entry(const MeasuredSpeedUp& measured) {
  if (!measured.speed_up) return note_entry(measured.mark);
  const SpeedUp& ratio = *measured.speed_up;
  const DigitStyle style = ratio_digits(ratio.value);
  const std::string value = write(ratio.value, style), percent = write_fixed(ratio.percent, 1);
  const std::string tail = " (" + percent + " %)";
  if (!ratio.spread) return {value + tail + " one run", {value, "", "", percent}, "one run"};
  const std::string low = write(ratio.low, style), high = write(ratio.high, style);
  Entry entry{value + " [" + low + ", " + high + "]" + tail, {value, low, high, percent}, {}};
  if (ratio.inconclusive()) add_note(entry, inconclusive_mark);
  return entry;
}

Entry without_percent(Entry entry) {
  if (!entry.has_number()) return entry;
  const std::size_t begin = entry.shown.find(" ("), end = entry.shown.find(')', begin);
  entry.shown.erase(begin, end + 1 - begin);
  entry.digits.pop_back();
  return entry;
}

Entry ratio_entry(const SpeedUp& ratio) {
  const DigitStyle style = ratio_digits(ratio.value);
  const std::string value = write(ratio.value, style);
  if (!ratio.spread) return {value + " one run", {value, "", ""}, "one run"};
  const std::string low = write(ratio.low, style), high = write(ratio.high, style);
  Entry entry{value + " [" + low + ", " + high + "]", {value, low, high}, {}};
  if (ratio.inconclusive()) add_note(entry, inconclusive_mark);
  return entry;
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

}  // namespace desmo::report
