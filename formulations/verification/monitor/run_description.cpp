// A monitored run in a line.
#include <cstdio>
#include <string>

#include "formulations/verification/monitor/monitored_run.h"

namespace desmo {

namespace {

std::string at(double time) {
  char text[40];
  std::snprintf(text, sizeof text, " at t = %.9g s", time);
  return text;
}

std::string flags_of(const MonitoredSummary& s) {
  std::string flags;
  const auto add = [&](const std::string& what, double time) {
    flags += (flags.empty() ? "" : "; ") + what + at(time);
  };
  if (s.first_degraded)
    add("instants " + std::to_string(s.degraded) + ", the first", s.first_degraded->time);
  if (s.crossing) add("a singular position or a jump", s.crossing->before);
  if (!s.gaps.empty())
    add("intervals that cannot be assembled " + std::to_string(s.gaps.size()) + ", the first",
        s.gaps.front().from);
  return flags;
}

}  // namespace

std::string describe(const MonitoredSummary& s, const Model& m) {
  const std::string flags = flags_of(s);
  const std::string before = flags.empty() ? "" : "; degraded before: " + flags;
  if (s.violated >= 0)
    return "another branch" + at(s.time) + ", constraint '" + m.constraints[s.violated].name + "'" +
           before;
  if (s.status != Status::solved) return describe(Summary{s}, m) + before;
  const char* const outcome = s.outcome() == Outcome::failed     ? "refused: "
                              : s.outcome() == Outcome::degraded ? "degraded: "
                                                                 : "converged: ";
  return outcome + flags + (flags.empty() ? "" : "; ") + std::to_string(s.instants) +
         " instants in all, " + describe_accuracy(s.condition, s.bound, Level::acceleration) +
         ", " + describe_scales(s.scales, Level::acceleration, m);
}

std::string describe_accuracy(double condition, const PerLevel<double>& bound, Level level) {
  const auto number = [](double x) {
    char text[16];
    std::snprintf(text, sizeof text, "%.1e", x);
    return std::string(text);
  };
  std::string result =
      "condition " + number(condition) + ", errors up to " + number(bound.position);
  if (level >= Level::velocity) result += ", " + number(bound.velocity) + " in velocity";
  if (level >= Level::acceleration)
    result += ", " + number(bound.acceleration) + " in acceleration";
  return result;
}

std::string describe_scales(const Scales& scales, Level level, const Model& m) {
  static constexpr const char* per_time[] = {"", "/s", "/s^2"};
  const std::string unit = m.length_unit == "1" ? "" : m.length_unit;
  std::string result;
  for (const Level l : all_levels) {
    if (l > level) break;
    const std::string per = per_time[static_cast<int>(l)];
    char text[80];
    std::snprintf(text, sizeof text, "%.3g%s%s or %.3g rad", scales.length[l],
                  unit.empty() ? "" : " ", (unit + per).c_str(), scales.rotation[l]);
    result += (result.empty() ? "relative to " : ", ") + (text + per);
  }
  return result;
}

}  // namespace desmo
