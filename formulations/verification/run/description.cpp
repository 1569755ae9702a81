// Sentences that describe a checked run or a live row.
#include <cmath>
#include <cstdlib>
#include <string>

#include "cases/mechanism/formatted.h"
#include "formulations/verification/run/checked_run.h"
#include "formulations/verification/run/live_run.h"

namespace desmo {

namespace {

/// Returns a bound with two digits, rounded up. Raises it by a hundredth until its text is not
/// below it; nextafter() raises even the smallest doubles.
std::string rounded_up(double bound) {
  for (double shown = bound;; shown = std::nextafter(1.01 * shown, INFINITY)) {
    std::string text = formatted("%.1e", shown);
    if (!(std::strtod(text.c_str(), nullptr) < bound)) return text;
  }
}

std::string flags_of(const CheckedSummary& s) {
  std::string flags;
  const auto add = [&](const std::string& what, double time) {
    flags += (flags.empty() ? "" : "; ") + what + formatted(" at t = %.9g s", time);
  };
  if (s.first_flag)
    add(std::to_string(s.flagged) + " rows, the first " + std::string(word_of(*s.first_flag)),
        s.first_flag->time);
  if (!s.gaps.empty())
    add("intervals that cannot be assembled " + std::to_string(s.gaps.size()) + ", the first",
        s.gaps.front().from);
  return flags;
}

}  // namespace

std::string_view word_of(const RowFlag& flag) {
  using enum RowFlag::Kind;
  return flag.kind == unproven ? "unproven"
         : flag.kind == branch ? "branch"
         : flag.kind == misfit ? "misfit"
                               : "crossing";
}

std::string describe(const CheckedSummary& s, const Model& m) {
  const std::string flags = flags_of(s);
  if (s.status != Status::solved)
    return describe(Summary{s}, m) + (flags.empty() ? "" : "; degraded before: " + flags);
  const char* const outcome = s.refused                          ? "refused: "
                              : s.outcome() == Outcome::failed   ? "failed: "
                              : s.outcome() == Outcome::degraded ? "degraded: "
                                                                 : "converged: ";
  return outcome + flags + (flags.empty() ? "" : "; ") + std::to_string(s.instants) +
         " instants in all, " + describe_radius(s);
}

std::string describe(const LiveSummary& s, const Model& m) {
  switch (s.fault) {
    case RowFault::none:
      return describe(Summary{s}, m) +
             (s.is_unreached()
                  ? formatted("; the motion to it is not proven beyond t = %.9g s", s.path.time)
                  : "");
    case RowFault::wrong_size:
      return "refused: there is not one value for each driver";
    case RowFault::not_finite:
      return "refused: a value or the time is not a finite number";
    case RowFault::time_not_later:
      return "refused: the time is not after the last good row";
  }
  return {};
}

std::string describe_radius(const CheckedSummary& s) {
  std::string text = "condition " + formatted("%.1e", s.condition) + ", errors at most " +
                     rounded_up(s.radius.position);
  if (s.level >= Level::velocity) text += ", " + rounded_up(s.radius.velocity) + " in velocity";
  if (s.level >= Level::acceleration)
    text += ", " + rounded_up(s.radius.acceleration) + " in acceleration";
  return text;
}

}  // namespace desmo
