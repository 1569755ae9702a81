#include "bench/kit/record/record.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "bench/kit/candidate.h"
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

/// Returns samples of a time [s] with the name of the clock that measured them.
Json time_json(const Json& seconds, Clock clock) {
  return {{"clock", clock == Clock::cpu ? "cpu" : "wall"}, {"seconds", seconds}};
}

/// Returns the times of all windows in every analysis [s], and the updates in each window; where no
/// updates were counted, the least time of each window alone.
Json windows_json(const TimingWindows& windows) {
  const std::vector<long>& updates = windows.updates();
  if (std::ranges::all_of(updates, [](long n) { return n == 0; }))
    return {{"least", rounded_list(windows.least())}};
  Json samples = Json::array();
  for (const std::vector<double>& sample : windows.samples())
    samples.push_back(rounded_list(sample));
  return {{"updates", updates}, {"samples", std::move(samples)}};
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

Json rounded_time_json(const std::vector<double>& seconds) {
  return time_json(rounded_list(seconds), Clock::cpu);
}

Json with_measurement(Json j, const Candidate& c) {
  j["status"] = c.is_timed() ? "ok" : c.is_not_run() ? "not_run" : "failed";
  if (!c.is_timed()) j["message"] = c.message().empty() ? "not timed" : c.message();
  if (c.is_not_run()) return j;
  const VerifyingRun& found = c.verifying_run();
  j["machine"] = processor_name();
  if (!found.model.empty()) j["model"] = found.model;
  if (!found.results.empty()) j["results"] = found.results;
  if (!c.is_timed()) return j;
  j["verification"] = errors_json(found.errors, found.level);
  if (c.threads() > 1) j["threads"] = c.threads();
  j["time"] = time_json(c.seconds(), c.clock());
  if (c.clock() == Clock::cpu) j["time"]["windows"] = windows_json(c.windows());
  j["setup_time"] = time_json(Json::array({found.setup_seconds}), Clock::cpu);
  j["iterations_per_step"] = found.iterations_per_step;
  if (found.residual) j["residual"] = *found.residual;
  return j;
}

double rounded(double value, int digits) {
  constexpr double max_number = 1e100;
  if (!(value <= max_number)) return max_number;
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return std::strtod(text, nullptr);
}

}  // namespace desmo::bench
