#pragma once

#include <array>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "formulations/verification/run/checked_run.h"

namespace desmo::bench {

/// Suffixes of the id of a formulation whose run is checked, as by `desmo solve --check`. What is
/// timed or counted then includes the check.
inline constexpr std::array<std::pair<std::string_view, CheckMode>, 2> check_suffixes{
    {{"/check:proof", CheckMode::proof}, {"/check:sample", CheckMode::sample}}};

/// Formulations with which the cost of checks is measured.
inline constexpr std::array<std::string_view, 4> checked_ids{
    "global_automatic_klu", "group_symbolic_inlined", "block_symbolic_inlined",
    "group_symbolic_explicit"};

/// Returns the check that an id's suffix asks for; none without a suffix.
inline CheckMode check_of(std::string_view id) {
  for (const auto& [suffix, mode] : check_suffixes)
    if (id.ends_with(suffix)) return mode;
  return CheckMode::none;
}

/// Returns the suffix of a mode; empty where nothing is checked.
inline std::string_view suffix_of(CheckMode mode) {
  for (const auto& [suffix, m] : check_suffixes)
    if (m == mode) return suffix;
  return {};
}

/// Returns an id without the suffix of its check.
inline std::string_view formulation_of(std::string_view id) {
  return id.substr(0, id.size() - suffix_of(check_of(id)).size());
}

/// Runs a motion, under a check unless the mode is none. Throws std::runtime_error where the motion
/// was solved, but the check flags a row: such a run does not cost what an ordinary one costs.
inline Summary run_under_check(Formulation& formulation, const TimeGrid& grid, const Request& asked,
                               Observer& observer, CheckMode mode) {
  if (mode == CheckMode::none) return formulation.run(grid, asked, observer);
  const CheckedSummary s = run_checked(formulation, grid, asked, observer, {.mode = mode});
  if (s.ok() && s.outcome() != Outcome::converged)
    throw std::runtime_error("the motion is not an ordinary one: " +
                             describe(s, formulation.model()));
  return Summary{s};
}

}  // namespace desmo::bench
