// Times and verifications.
#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "report/read/readers.h"
#include "report/text/digits.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

template <class Read>
std::vector<double> read_windows(const RecordValue& node, std::size_t count, const Read& read) {
  std::vector<double> values = node.list(read);
  if (values.size() != count)
    node.complain(std::to_string(values.size()) + " windows of " + std::to_string(count));
  return values;
}

// Returns the number of instants of each window. They differ by one at most, as desmo_bench cuts
// the motion.
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

// Returns the time of so many instants as the only window.
Windows one_window(std::int64_t instants, const std::vector<double>& seconds) {
  Windows whole{.least = {std::ranges::min(seconds)},
                .instants = {static_cast<double>(instants)},
                .updates = {0}};
  for (const double sample : seconds) whole.samples.push_back({sample});
  return whole;
}

Windows read_windows(const RecordValue& node, const RecordSettings& settings) {
  const auto count = static_cast<std::size_t>(*settings.windows);
  Windows windows;
  const auto samples = node.find("samples");
  if (!samples) {
    windows.least = read_windows(node["least"], count, &RecordValue::sample);
    return windows;
  }
  windows.samples = samples->list(
      [&](const RecordValue& sample) { return read_windows(sample, count, &RecordValue::sample); });
  if (windows.samples.empty()) samples->complain("there is none");
  windows.least = least_of(windows.samples, count);
  windows.updates = read_windows(node["updates"], count, [](const RecordValue& updates) {
    return static_cast<double>(updates.integer(0));
  });
  windows.instants = instants_of_windows(settings.instants, count);
  return windows;
}

// Throws InputError where the least times of windows add up to more than the shortest repetition,
// which consists of the same windows. A thousandth more is allowed for the clock.
void require_within_repetition(const RecordValue& node, const Time& time) {
  const std::vector<double>& least = time.windows.least;
  if (std::accumulate(least.begin(), least.end(), 0.0) > 1.001 * std::ranges::min(time.seconds))
    node.complain("together they are longer than a whole repetition");
}

}  // namespace

std::vector<double> read_samples(const RecordValue& node) {
  std::vector<double> seconds = node.list(&RecordValue::sample);
  if (seconds.empty()) node.complain("at least one sample was expected");
  return seconds;
}

void require_clock(const RecordValue& time, Clock clock, std::string_view what) {
  const RecordValue node = time["clock"];
  if (node.one_of({"cpu", "wall"}) != static_cast<std::size_t>(clock))
    node.complain(std::string(what) + " is measured by \"" +
                  (clock == Clock::cpu ? "cpu" : "wall") + "\"");
}

Time read_time(const RecordValue& node, const RecordSettings& settings, std::string_view id) {
  const Clock clock = is_by_wall(id) ? Clock::wall : Clock::cpu;
  require_clock(node, clock, id);
  Time time{clock, read_samples(node["seconds"]), {}};
  if (!settings.windows) return time;
  if (clock == Clock::wall) {
    // Several threads deliver instants in another order every time, so that a piece of the motion
    // has no time of its own.
    time.windows = one_window(settings.instants, time.seconds);
    return time;
  }
  const RecordValue windows = node["windows"];
  time.windows = read_windows(windows, settings);
  require_within_repetition(windows, time);
  return time;
}

Time read_step_time(const RecordValue& node) {
  require_clock(node, Clock::cpu, "a step");
  std::vector<double> seconds = read_samples(node["seconds"]);
  Windows step = one_window(1, seconds);
  return {Clock::cpu, std::move(seconds), std::move(step)};
}

Status read_status(const RecordValue& node) {
  return static_cast<Status>(node.one_of({"ok", "failed", "not_run"}));
}

std::string excess(const LevelNumbers& found, const LevelNumbers& allowed) {
  std::string text;
  for (const auto& [what, level] : {std::pair{"position", &LevelNumbers::position},
                                    {"velocity", &LevelNumbers::velocity},
                                    {"acceleration", &LevelNumbers::acceleration}})
    if (found.*level > allowed.*level)
      text += (text.empty() ? "" : "; ") +
              sentence("common.more_than_allowed", {{"what", what},
                                                    {"difference", write_shortest(found.*level)},
                                                    {"limit", write_shortest(allowed.*level)}});
  return text;
}

void fail(Measurement& measurement, std::string reason) {
  if (reason.empty()) return;
  measurement.status = Status::failed;
  measurement.message = std::move(reason);
  measurement.time = {};
}

}  // namespace desmo::report
