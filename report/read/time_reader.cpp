#include "report/read/time_reader.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>

namespace desmo::report {
namespace {

const char* name_of(Clock clock) { return clock == Clock::cpu ? "cpu" : "wall"; }

void require_clock(const JsonNode& time, Clock clock, const std::string& why) {
  if (read_clock(time["clock"]) != clock)
    time["clock"].complain(why + " is measured by \"" + name_of(clock) + "\"");
}

std::vector<double> read_samples(const JsonNode& list) {
  std::vector<double> seconds;
  for (const JsonNode& sample : list.elements()) seconds.push_back(sample.sample());
  if (seconds.empty()) list.complain("at least one sample was expected");
  return seconds;
}

template <class Read>
std::vector<double> read_each_window(const JsonNode& list, std::size_t count, const Read& read) {
  std::vector<double> values;
  for (const JsonNode& window : list.elements()) values.push_back(read(window));
  if (values.size() != count)
    list.complain(std::to_string(values.size()) + " windows of " + std::to_string(count));
  return values;
}

double window_seconds(const JsonNode& node) { return node.sample(); }
double window_updates(const JsonNode& node) { return static_cast<double>(node.integer(0)); }

// Equal by instants, the rest shared out as desmo_bench does.
std::vector<double> instants_of_windows(std::int64_t instants, std::size_t count) {
  const auto windows = static_cast<std::int64_t>(count);
  std::vector<double> of_each;
  for (std::int64_t i = 0; i < windows; ++i)
    of_each.push_back(static_cast<double>((i + 1) * instants / windows - i * instants / windows));
  return of_each;
}

std::vector<double> least_of(const std::vector<std::vector<double>>& samples, std::size_t count) {
  std::vector<double> least(count, std::numeric_limits<double>::infinity());
  for (const std::vector<double>& sample : samples)
    for (std::size_t i = 0; i < count; ++i) least[i] = std::min(least[i], sample[i]);
  return least;
}

// Several threads deliver in another order every time: a piece of the motion has no time of its
// own, and the whole motion is the only window.
Windows one_window(const Settings& settings, const std::vector<double>& seconds) {
  Windows whole{.least = {std::ranges::min(seconds)},
                .instants = {static_cast<double>(settings.instants)},
                .updates = {0},
                .samples = {}};
  for (const double sample : seconds) whole.samples.push_back({sample});
  return whole;
}

Windows read_windows(const JsonNode& node, const Settings& settings) {
  const auto count = static_cast<std::size_t>(*settings.windows);
  Windows windows;
  const auto samples = node.find("samples");
  if (!samples) {
    windows.least = read_each_window(node["least"], count, window_seconds);
    return windows;
  }
  for (const JsonNode& sample : samples->elements())
    windows.samples.push_back(read_each_window(sample, count, window_seconds));
  if (windows.samples.empty()) samples->complain("there is none");
  windows.least = least_of(windows.samples, count);
  windows.updates = read_each_window(node["updates"], count, window_updates);
  windows.instants = instants_of_windows(settings.instants, count);
  return windows;
}

// Windows are all that a repetition consists of, so that their least times cannot add up to more
// than the least repetition; a thousandth is left to the clock.
void require_within_repetition(const JsonNode& node, const Time& time) {
  const std::vector<double>& least = time.windows.least;
  if (std::accumulate(least.begin(), least.end(), 0.0) > 1.001 * std::ranges::min(time.seconds))
    node.complain("together they are longer than a whole repetition");
}

}  // namespace

Clock read_clock(const JsonNode& node) {
  const std::string clock = node.text();
  if (clock == "cpu") return Clock::cpu;
  if (clock == "wall") return Clock::wall;
  node.complain("\"" + clock + "\" is none of \"cpu\", \"wall\"");
}

Time read_time(const JsonNode& node, const Settings& settings, std::string_view id) {
  const Clock clock = is_by_wall(id) ? Clock::wall : Clock::cpu;
  require_clock(node, clock, std::string(id));
  Time time{clock, read_samples(node["seconds"]), {}};
  if (!settings.windows) return time;
  if (clock == Clock::wall) {
    time.windows = one_window(settings, time.seconds);
    return time;
  }
  const JsonNode windows = node["windows"];
  time.windows = read_windows(windows, settings);
  require_within_repetition(windows, time);
  return time;
}

std::vector<double> read_cpu_seconds(const JsonNode& node) {
  require_clock(node, Clock::cpu, "a step");
  return read_samples(node["seconds"]);
}

}  // namespace desmo::report
