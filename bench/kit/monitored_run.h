#pragma once

#include <array>
#include <stdexcept>
#include <string_view>

#include "formulations/verification/monitor/monitored_run.h"

namespace desmo::bench {

/// Ends the id of a formulation whose run is monitored, as in `desmo solve`: what that costs is
/// part of what is timed or counted.
inline constexpr std::string_view monitored_suffix = "/monitored";

/// Formulations with which the cost of monitors is measured.
inline constexpr std::array<std::string_view, 4> monitored_ids{
    "global_automatic_klu", "group_symbolic_inlined", "block_symbolic_inlined",
    "group_symbolic_explicit"};

inline bool is_monitored(std::string_view id) { return id.ends_with(monitored_suffix); }

/// Returns the id of the formulation itself.
inline std::string_view formulation_of(std::string_view id) {
  return is_monitored(id) ? id.substr(0, id.size() - monitored_suffix.size()) : id;
}

/// Runs a motion under all monitors. Throws std::runtime_error where one of them finds something:
/// that is not the motion whose cost is asked for.
inline Summary run_under_monitors(Formulation& formulation, const TimeGrid& grid,
                                  const Request& asked, Observer& observer) {
  const MonitoredSummary s = run_monitored(formulation, grid, asked, observer, {});
  if (s.status == Status::solved && s.outcome() != Outcome::converged)
    throw std::runtime_error("the motion is not an ordinary one: " +
                             describe(s, formulation.model()));
  return Summary{s};
}

}  // namespace desmo::bench
