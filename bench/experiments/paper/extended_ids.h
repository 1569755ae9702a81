#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "bench/kit/time/clock.h"
#include "formulations/id.h"
#include "formulations/verification/run/check_options.h"

namespace desmo::paper {

/// A formulation with settings, and how it is run and timed.
struct TimedConfiguration : Configuration {
  bench::Clock clock = bench::Clock::cpu;
  CheckMode check = CheckMode::none;
};

/// Ids beyond the paper's, measured at the largest of its sizes: the reference with its own best
/// settings, and generated code with the same guess. The latter solves one part after the other,
/// equal axles at once (lanes), or segments of the motion at once. Lanes and segments are on
/// registers of 256 and of 512 bits; segments also on two threads.
inline constexpr std::array<std::string_view, 9> extended_ids{
    "global_automatic_klu/guess:adams8/jacobian:step/tolerance:1e-10",
    "group_symbolic_inlined/guess:adams8/tolerance:1e-10",
    "group_symbolic_explicit/guess:adams8/tolerance:1e-10",
    "group_symbolic_explicit/guess:adams8/lanes:4/tolerance:1e-10",
    "group_symbolic_explicit/guess:adams8/lanes:8/tolerance:1e-10",
    "group_symbolic_explicit/guess:adams8/segments:4/tolerance:1e-10",
    "group_symbolic_explicit/guess:adams8/segments:8/tolerance:1e-10",
    "group_symbolic_explicit/guess:adams8/segments:4/threads:2/tolerance:1e-10",
    "group_symbolic_explicit/guess:adams8/segments:8/threads:2/tolerance:1e-10"};

/// KLU on the whole matrix as one block: compared with KLU as it is, it shows what the irreducible
/// blocks gain that KLU finds itself.
inline constexpr std::string_view reference_of_one_block = "global_automatic_klu/btf:off";

/// Returns the configuration of an id; where it has several threads, also what it is compared with:
/// the same on one thread, by the same clock. Throws what parse_id throws.
std::vector<TimedConfiguration> with_counterpart(std::string_view id);

/// Returns what is measured at one size in addition to the table of variants: the extended ids with
/// their counterparts, KLU as one block, and checked runs.
std::vector<TimedConfiguration> beyond_the_table();

/// The request that extended_ids of one thread are timed with, too.
inline constexpr std::string_view extended_request = "outputs";

}  // namespace desmo::paper
