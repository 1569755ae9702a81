#include "bench/experiments/paper/phases.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "bench/kit/delivery.h"
#include "bench/kit/time/clock.h"
#include "formulations/motion/internals.h"

namespace desmo::paper {

using namespace bench;

namespace {

/// Returns the time that measuring one phase takes by itself [s].
double clock_seconds() {
  constexpr int calls = 20'000;
  double best = 1;
  for (int i = 0; i < 5; ++i) {
    Profile empty;
    const double start = now(Clock::wall);
    for (int call = 0; call < calls; ++call) empty.measure(Phase::residual, [] {});
    best = std::min(best, (now(Clock::wall) - start) / calls);
  }
  return best;
}

/// Measures one pass over the grid. clock: the result of clock_seconds().
PhaseTimes one_pass(Formulation& formulation, Profile& profile, const TimeGrid& grid,
                    double clock) {
  Delivery observer(formulation.model().coordinates());
  profile = {};
  const double start = now(Clock::wall);
  const Summary summary = formulation.run(grid, {}, observer);
  const double total = now(Clock::wall) - start;
  if (!summary.ok()) throw std::runtime_error(describe(summary, formulation.model()));

  const long calls = std::accumulate(profile.calls.begin(), profile.calls.end(), 0L);
  PhaseTimes times{};
  double measured = 0;
  for (int p = 0; p < phase_count; ++p) {
    // About half of the cost of a measurement falls into the time that it measures.
    const double seconds = std::max(0.0, profile.seconds[p] - profile.calls[p] * clock / 2);
    times[p] = seconds / grid.instants;
    measured += seconds;
  }
  times.back() = std::max(0.0, total - calls * clock - measured) / grid.instants;
  return times;
}

}  // namespace

PhaseTimes measure_phases(const Variant& variant, const Settings& settings, const Model& model,
                          const TimeGrid& grid) {
  constexpr int passes = 5;
  Profile profile;
  const auto formulation = make_profiled_formulation(variant, model, settings, profile);
  const double clock = clock_seconds();
  std::vector<PhaseTimes> times;
  for (int i = 0; i < passes; ++i) times.push_back(one_pass(*formulation, profile, grid, clock));
  std::ranges::sort(times, {},
                    [](const PhaseTimes& t) { return std::accumulate(t.begin(), t.end(), 0.0); });
  return times[passes / 2];
}

}  // namespace desmo::paper
