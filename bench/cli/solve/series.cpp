#include "bench/cli/solve/series.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>

#include "bench/cli/solve/failure_notes.h"
#include "formulations/verification/reference/wide_instant.h"

namespace desmo::cli {
namespace {

/// Size of collected text [bytes] from which (≥) it is written to the output.
constexpr std::size_t min_flush_size = std::size_t{1} << 16;

/// Returns the shortest decimal number that reads back as this double.
Quadruple as_written(double value) {
  char text[32] = {};
  std::to_chars(text, text + sizeof text - 1, value);
  return Quadruple(text);
}

/// Returns start + count · step, computed with the decimal numbers of as_written() and rounded to a
/// double.
double decimal_time(double start, double step, std::int64_t count) {
  // Where the decimals cancel, roundings of the sum leave about 1e-33 |start|. Where they do not,
  // at least 4e-27 |start| is left: decimals have 17 digits, and count is below 2³¹. So a time with
  // |time| < max_rounding · |start| is 0.
  constexpr double max_rounding = 1e-30;
  const Quadruple first = as_written(start), time = first + count * as_written(step);
  return abs(time) < max_rounding * abs(first) ? 0 : static_cast<double>(time);
}

/// Appends the shortest decimal number that reads back as this double; of −0 that of 0.
void append_number(double value, std::string& text) {
  char digits[32];
  const double unsigned_zero = value + 0.0;  // −0 + 0 = 0
  const auto end = std::to_chars(digits, digits + sizeof digits, unsigned_zero).ptr;
  text.append(digits, end);
}

/// Appends a time [s]. An instant of the grid is appended as decimal_time() computes it from the
/// numbers that the user wrote: TimeGrid::time() multiplies the rounding of `step` by the number of
/// steps. Any other time is appended as it is.
void append_time(double time, const TimeGrid& grid, std::string& text) {
  const double index = std::round((time - grid.start) / grid.interval());
  const bool is_instant =
      index >= 0 && index < grid.instants && grid.time(static_cast<int>(index)) == time;
  if (is_instant)
    time = decimal_time(grid.start, grid.step,
                        static_cast<std::int64_t>(index) * grid.steps_per_interval);
  append_number(time, text);
}

/// Returns whether a column has a number at an instant. Rates have none on a change point, ratios
/// of rates none where nothing moves.
bool is_known(const Column& column, const Instant& instant) {
  return column.coordinate < 0 || (!instant.q.empty() && !std::isnan(column.value(instant)));
}

std::string json_heading(const SeriesHeading& heading) {
  using Json = nlohmann::ordered_json;
  Json columns = Json::array({{{"name", "t"}, {"unit", "s"}}});
  for (const Column& c : heading.columns)
    columns.push_back({{"name", c.name}, {"unit", c.unit.name}});
  if (!heading.remark.empty()) columns.push_back({{"name", heading.remark}, {"unit", "-"}});
  const Json all = {{"format", "desmo-series"},           {"version", 1},
                    {"mechanism", heading.mechanism},     {"scene", heading.scene},
                    {"formulation", heading.formulation}, {"columns", columns}};
  return all.dump() + "\n";
}

}  // namespace

std::string first_line(const SeriesHeading& heading) {
  if (heading.format == SeriesFormat::jsonl) return json_heading(heading);
  // No heading needs quotes: names have neither commas, quotes nor line ends (is_name()).
  std::string text = "t [s]";
  for (const Column& c : heading.columns) text += "," + c.heading();
  return text + (heading.remark.empty() ? "" : "," + heading.remark) + "\n";
}

void append_line(const SeriesHeading& heading, const Instant& instant, std::string_view remark,
                 std::string& text) {
  const bool is_json = heading.format == SeriesFormat::jsonl;
  const std::string_view missing = is_json ? "null" : "", quote = is_json ? "\"" : "";
  if (is_json) text += '[';
  if (is_json && !std::isfinite(instant.time))
    text += missing;
  else
    append_time(instant.time, heading.grid, text);
  for (const Column& c : heading.columns) {
    text += ',';
    if (is_known(c, instant))
      append_number(c.value(instant), text);
    else
      text += missing;
  }
  if (!heading.remark.empty()) {
    text += ',';
    if (remark.empty())
      text += missing;
    else
      text.append(quote).append(remark).append(quote);
  }
  text += is_json ? "]\n" : "\n";
}

SeriesWriter::SeriesWriter(const SeriesHeading& heading, Measures& measures, OutputFile& output,
                           bench::Progress* progress)
    : heading_(heading),
      measures_(measures),
      output_(output),
      progress_(progress),
      text_(first_line(heading)) {}

Flow SeriesWriter::observe(const Instant& solved) noexcept try {
  const Instant instant = measures_.extend(solved);
  // A row has a remark if it is flagged. A flagged row on a change point lacks rates.
  const bool may_lack = !remark_.empty();
  const auto finite = [&](const Column& column) {
    const double value = column.value(instant);
    return std::isfinite(value) ||
           ((column.may_lack || (may_lack && column.level > Level::position)) && std::isnan(value));
  };
  if (const auto c = std::ranges::find_if_not(heading_.columns, finite);
      c != heading_.columns.end()) {
    overflow_ = overflow_text(c->name, instant.time);
    return Flow::stop;
  }
  append_line(heading_, instant, std::exchange(remark_, {}), text_);
  if (text_.size() >= min_flush_size) flush();
  if (progress_) progress_->add_done();
  return Flow::go_on;
} catch (...) {
  unwritable_ = std::current_exception();
  return Flow::stop;
}

const std::string& SeriesWriter::overflow() const {
  if (unwritable_) std::rethrow_exception(unwritable_);
  return overflow_;
}

void SeriesWriter::flush() {
  output_.write(text_);
  text_.clear();
}

}  // namespace desmo::cli
