#include "bench/kit/record/record.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "formulations/base/per_level.h"
#include "results/schema_version.h"

namespace desmo::bench {

using Json = nlohmann::ordered_json;

namespace {

const std::string& required(const std::string& path) {
  if (path.empty())
    throw std::invalid_argument("--record FILE is missing: what is measured goes there");
  return path;
}

Json head(const Json& environment) {
  return {{"schema", "desmo-results"}, {"schema_version", schema_version}, {"record", environment}};
}

/// Returns the text of a record: its head indented, and each element of a list on a line of its
/// own. So a person can read the head and skip the elements.
///
/// section: name of the only section. lists: an object of arrays; empty ones are left out.
std::string record_text(const Json& environment, const std::string& section, const Json& lists) {
  std::string text = head(environment).dump(1);
  text.erase(text.rfind('\n'));  // the last line, a brace
  text += ",\n " + Json(section).dump() + ": {";
  const char* separator = "\n  ";
  for (const auto& [name, list] : lists.items()) {
    if (list.empty()) continue;
    text += separator + Json(name).dump() + ": [";
    for (std::size_t i = 0; i < list.size(); ++i)
      text += (i == 0 ? "\n   " : ",\n   ") + list[i].dump();
    text += "\n  ]";
    separator = ",\n  ";
  }
  return text + "\n }\n}\n";
}

Json rounded_list(const std::vector<double>& seconds) {
  Json list = Json::array();
  for (const double s : seconds) list.push_back(rounded(s, 5));
  return list;
}

}  // namespace

RecordWriter::RecordWriter(const std::string& path, const std::string& command,
                           const std::string& experiment)
    : file_(required(path)),
      run_{utc_now(), command, load_averages(), {}},
      experiment_(experiment) {}

void RecordWriter::write(const TimeGrid& grid, const Json& lists, std::optional<int> windows) {
  run_.load_after = load_averages();
  Json environment = environment_json(run_, grid);
  if (windows) environment["settings"]["windows"] = *windows;
  file_.write(record_text(environment, experiment_, lists));
  file_.finish();
}

Json record_head(const std::string& command, const TimeGrid& grid) {
  return head(environment_json({utc_now(), command, load_averages(), {}}, grid));
}

Json per_level_json(const PerLevel<double>& values) {
  Json j;
  for (const Level level : all_levels) j[level_names[level]] = values[level];
  return j;
}

Json errors_json(const Differences& errors, Level level) {
  Json j = {{"instants", errors.instants}};
  for (const Level l : all_levels)
    if (l <= level) j[level_names[l]] = errors[l];
  return j;
}

Json time_json(const std::vector<double>& seconds, Clock clock) {
  return {{"clock", clock_name(clock)}, {"seconds", seconds}};
}

Json rounded_time_json(const std::vector<double>& seconds) {
  return {{"clock", clock_name(Clock::cpu)}, {"seconds", rounded_list(seconds)}};
}

Json windows_json(const TimingWindows& windows) {
  const std::vector<long>& updates = windows.updates();
  if (std::ranges::all_of(updates, [](long n) { return n == 0; }))  // uncounted
    return {{"least", rounded_list(windows.least())}};
  Json samples = Json::array();
  for (const std::vector<double>& sample : windows.samples())
    samples.push_back(rounded_list(sample));
  return {{"updates", updates}, {"samples", std::move(samples)}};
}

double rounded(double value, int digits) {
  constexpr double max_number = 1e100;
  if (!(value <= max_number)) return max_number;
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return std::strtod(text, nullptr);
}

const char* clock_name(Clock clock) { return clock == Clock::cpu ? "cpu" : "wall"; }

}  // namespace desmo::bench
