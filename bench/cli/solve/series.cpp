#include "bench/cli/solve/series.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "bench/cli/solve/check_notes.h"
#include "bench/cli/solve/time_text.h"

namespace desmo::cli {
namespace {

constexpr std::size_t enough_to_write = std::size_t{1} << 16;

void append_word(std::string_view word, std::string& text) {
  if (word.empty())
    text += ",null";
  else
    text.append(",\"").append(word).append("\"");
}

/// On a change point there are no rates, and no ratio of them at rest.
bool is_known(const Column& column, const Instant& instant) {
  return column.coordinate < 0 || (!instant.q.empty() && !std::isnan(column.value(instant)));
}

/// As RFC 4180 has it.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

class Csv final : public SeriesFormat {
 public:
  std::string heading(const SeriesHeading& heading) const override {
    std::string text = "t [s]";
    for (const Column& c : heading.columns) text += "," + csv_field(c.heading());
    return text + (heading.remark.empty() ? "" : "," + heading.remark) + "\n";
  }
  void append(const SeriesHeading& heading, const Instant& instant, std::string& text,
              std::string_view remark) const override {
    append_time(instant.time, heading.grid, text);
    for (const Column& c : heading.columns) {
      text += ',';
      if (is_known(c, instant)) append_number(c.value(instant), text);
    }
    if (!heading.remark.empty()) text.append(",").append(remark);
    text += '\n';
  }
};

class JsonLines final : public SeriesFormat {
 public:
  std::string heading(const SeriesHeading& heading) const override {
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
  void append(const SeriesHeading& heading, const Instant& instant, std::string& text,
              std::string_view remark) const override {
    text += '[';
    if (std::isfinite(instant.time))
      append_time(instant.time, heading.grid, text);
    else
      text += "null";
    for (const Column& c : heading.columns) {
      text += ',';
      if (is_known(c, instant))
        append_number(c.value(instant), text);
      else
        text += "null";
    }
    if (!heading.remark.empty()) append_word(remark, text);
    text += "]\n";
  }
};

}  // namespace

std::unique_ptr<SeriesFormat> series_format(std::string_view name) {
  if (name == "jsonl") return std::make_unique<JsonLines>();
  return std::make_unique<Csv>();
}

SeriesWriter::SeriesWriter(SeriesHeading heading, Measures& measures,
                           std::unique_ptr<SeriesFormat> format, OutputFile& output,
                           bench::Progress* progress)
    : heading_(std::move(heading)),
      measures_(measures),
      format_(std::move(format)),
      output_(output),
      progress_(progress),
      text_(format_->heading(heading_)) {}

Flow SeriesWriter::observe(const Instant& solved) noexcept try {
  const Instant instant = measures_.extend(solved);
  const bool may_lack = !remark_.empty();  // rates, on a change point
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
  format_->append(heading_, instant, text_, std::exchange(remark_, {}));
  if (text_.size() >= enough_to_write) flush();
  if (progress_) progress_->done();
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
