#include "bench/kit/record/time_json.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "bench/kit/record/record_layout.h"

namespace desmo::bench {

namespace {

using Json = nlohmann::ordered_json;

Json rounded_list(const std::vector<double>& seconds) {
  Json list = Json::array();
  for (const double s : seconds) list.push_back(rounded(s));
  return list;
}

}  // namespace

const char* clock_name(Clock clock) { return clock == Clock::cpu ? "cpu" : "wall"; }

Json time_json(const std::vector<double>& seconds, Clock clock) {
  return {{"clock", clock_name(clock)}, {"seconds", seconds}};
}

Json windows_json(const TimingWindows& windows) {
  const std::vector<long>& updates = windows.updates();
  if (std::ranges::count(updates, 0) == std::ssize(updates))  // nobody counts
    return {{"least", rounded_list(windows.least())}};
  Json samples = Json::array();
  for (const std::vector<double>& sample : windows.samples())
    samples.push_back(rounded_list(sample));
  return {{"updates", updates}, {"samples", std::move(samples)}};
}

}  // namespace desmo::bench
